// What the mechanism file has beyond the thesis, and what is wrong with it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "core/robot_file/mech_extras.hpp"
#include "core/robot_file/mech_file.hpp"
#include "core/robot_file/robot_writer.hpp"

namespace abstand::robot_file {
namespace mech_extras_test {

const char* const kChain = "chain\nframe 1 0 0 0 theta\nframe 2 0 90 d 0\nframe 3 100 0 0 0\nend_chain\n";

Robot read(const std::string& text) {
  return parseMech("units\nlength mm\nangle degrees\nend_units\n" + (kChain + text), "r.mech");
}

TEST(MechExtras, AreReadInUnitsOfFile) {
  const Robot r = read(
      "limits\n limit 1 -90 180 45 30\n limit 2 none 500 none none\nend_limits\n"
      "inertia\n body 3 2.5 100 0 -100 1 2 3 0.1 0.2 0.3\nend_inertia\n"
      "geometry\n collision 3 mesh my%20link.stl 1 1 2  1 0 0 100  0 1 0 0  0 0 1 0\n"
      " visual 0 sphere 50  1 0 0 0  0 1 0 0  0 0 1 0\n collision 1 capsule 10 0  1 0 0 0  0 0 -1 0  0 1 0 "
      "0\nend_geometry\n"
      "names\n name 1 upper%20arm shoulder\n name 3 tool\nend_names\n");
  const auto& f = r.mechanism.frames;
  EXPECT_DOUBLE_EQ(f[0].limits.lower, -kPi / 2);
  EXPECT_DOUBLE_EQ(f[0].limits.upper, kPi);
  EXPECT_DOUBLE_EQ(f[0].limits.velocity, kPi / 4);
  EXPECT_EQ(f[0].limits.effort, 30.0);
  EXPECT_EQ(f[1].limits.lower, -kInfinity);
  EXPECT_EQ(f[1].limits.upper, 0.5);
  EXPECT_EQ(f[1].limits.effort, kInfinity);
  EXPECT_EQ(f[2].inertia.mass, 2.5);
  EXPECT_EQ(f[2].inertia.com_F, Vector3d(0.1, 0, -0.1));
  EXPECT_EQ(f[2].inertia.inertia_F(0, 2), 0.2);
  EXPECT_EQ(f[0].name, "upper arm");
  EXPECT_EQ(f[0].joint, "shoulder");
  EXPECT_EQ(f[1].name, "2");
  ASSERT_EQ(r.geometry.size(), 3u);
  EXPECT_EQ(r.geometry[0].mesh, "my link.stl");
  EXPECT_EQ(r.geometry[0].frame, 2);
  EXPECT_EQ(r.geometry[0].scale, Vector3d(1, 1, 2));
  EXPECT_DOUBLE_EQ(r.geometry[0].X_FG.translation().x(), 0.1);
  EXPECT_EQ(r.geometry[1].frame, -1);
  EXPECT_EQ(r.geometry[1].use, GeometryUse::kVisual);
  EXPECT_DOUBLE_EQ(std::get<geometry::Sphere>(*r.geometry[1].shape).radius, 0.05);
  EXPECT_EQ(std::get<geometry::Capsule>(*r.geometry[2].shape).length, 0.0);
}

TEST(MechExtras, SixthNumberIsAcceleration) {
  const Robot r = read("limits\n limit 1 -90 180 45 30 90\n limit 2 none 500 none none 2500\nend_limits\n");
  EXPECT_DOUBLE_EQ(r.mechanism.frames[0].limits.acceleration, kPi / 2);
  EXPECT_DOUBLE_EQ(r.mechanism.frames[1].limits.acceleration, 2.5);
  const Robot unknown = read("limits\n limit 1 -90 180 45 30 none\n limit 2 0 500 10 none\nend_limits\n");
  EXPECT_EQ(unknown.mechanism.frames[0].limits.acceleration, kInfinity);
  EXPECT_EQ(unknown.mechanism.frames[1].limits.acceleration, kInfinity);
}

TEST(MechExtras, MimicSharesDof) {
  const Robot r = read("mapping\n dof 0 1\n mimic 0 2 10 5\nend_mapping\n");
  EXPECT_EQ(r.mechanism.dof, 1);
  EXPECT_EQ(r.mechanism.frames[1].dof, 0);
  EXPECT_TRUE(r.mechanism.frames[1].mimic);
  EXPECT_DOUBLE_EQ(r.mechanism.frames[1].offset, 0.01);
  EXPECT_EQ(r.mechanism.frames[1].scale, 5.0);
}

TEST(MechExtras, WordsEncodeAnyText) {
  for (const std::string text : {"plain.stl", "a b", "50%", "#1", "%20"})
    EXPECT_EQ(fromMechWord(mechWord(text)), text);
  EXPECT_EQ(fromMechWord("a%2"), std::nullopt);
  EXPECT_EQ(fromMechWord("a%zz"), std::nullopt);
  EXPECT_EQ(fromMechWord("%0a"), std::nullopt);
}

TEST(MechExtras, RoundTrip) {
  const Robot r = read(
      "mapping\n dof 0 1 15 -1\n mimic 0 2 10 5\nend_mapping\nlink\n id 3\n center 1 0 0 1 0 1 0 2 0 0 1 "
      "3\nend_link\n"
      "limits\n limit 1 -90 180 45 none\n limit 2 none 500 none none 2500\nend_limits\nnames\n name 1 "
      "a%20b\nend_names\n"
      "geometry\n visual 0 ellipsoid 10 20 30  1 0 0 0  0 1 0 0  0 0 1 0\nend_geometry\n");
  const std::string once = mechText(r);
  EXPECT_EQ(mechText(parseMech(once, "r.mech")), once);
}

struct BadCase {
  const char* name;
  const char* text;  ///< behind four lines of units and five of the chain
  int line, column;
  const char* says;
};
void PrintTo(const BadCase& c, std::ostream* out) { *out << c.name; }
class BadMechExtras : public ::testing::TestWithParam<BadCase> {};

TEST_P(BadMechExtras, AreRejectedWithPosition) {
  try {
    read(GetParam().text);
    FAIL() << "was read";
  } catch (const ParseError& e) {
    EXPECT_EQ(e.pos().line, GetParam().line + 9) << e.what();
    EXPECT_EQ(e.pos().column, GetParam().column) << e.what();
    EXPECT_THAT(e.what(), ::testing::HasSubstr(GetParam().says));
  }
}

#define POSE " 1 0 0 0 0 1 0 0 0 0 1 0"
INSTANTIATE_TEST_SUITE_P(
    Values, BadMechExtras,
    ::testing::Values(
        BadCase{"mimic before", "mapping\nmimic 0 1\nend_mapping\n", 2, 7, "defined before"},
        BadCase{"limit of nothing", "limits\nlimit 9 0 1 1 1\nend_limits\n", 2, 7,
                "a frame that a chain defines"},
        BadCase{"limit of a fixed frame", "limits\nlimit 3 0 1 1 1\nend_limits\n", 2, 7, "constant"},
        BadCase{"limit twice", "limits\nlimit 1 0 1 1 1\nlimit 1 0 1 1 1\nend_limits\n", 3, 7, "second time"},
        BadCase{"crossed", "limits\nlimit 1 2 1 1 1\nend_limits\n", 2, 11, "not below"},
        BadCase{"slow", "limits\nlimit 1 0 1 -1 1\nend_limits\n", 2, 13, "from 0 on"},
        BadCase{"weak", "limits\nlimit 1 0 1 1 -1\nend_limits\n", 2, 15, "from 0 on"},
        BadCase{"word", "limits\nlimit 1 non 1 1 1\nend_limits\n", 2, 9, "did you mean none?"},
        BadCase{"few", "limits\nlimit 1 0 1 1\nend_limits\n", 2, 14, "expected 5"},
        BadCase{"no acceleration", "limits\nlimit 1 0 1 1 1 0\nend_limits\n", 2, 17, "above 0"},
        BadCase{"negative acceleration", "limits\nlimit 1 0 1 1 1 -3\nend_limits\n", 2, 17, "above 0"},
        BadCase{"acceleration in words", "limits\nlimit 1 0 1 1 1 nan\nend_limits\n", 2, 17, "acceleration"},
        BadCase{"too many limits", "limits\nlimit 1 0 1 1 1 1 1\nend_limits\n", 2, 17, "expected 5"},
        BadCase{"alone", "limits\nlimit\nend_limits\n", 2, 6, "expected 1"},
        BadCase{"negative mass", "inertia\nbody 1 -1 0 0 0 1 1 1 0 0 0\nend_inertia\n", 2, 8,
                "negative mass"},
        BadCase{"kind", "geometry\nvisual 1 cube 1" POSE "\nend_geometry\n", 2, 10, "cuboid"},
        BadCase{"size", "geometry\nvisual 1 sphere 0" POSE "\nend_geometry\n", 2, 17, "positive"},
        BadCase{"sizes", "geometry\nvisual 1 cylinder 1" POSE "\nend_geometry\n", 2, 44, "expected 16"},
        BadCase{"scale", "geometry\nvisual 1 mesh a.stl 1 0 1" POSE "\nend_geometry\n", 2, 23, "scale 0"},
        BadCase{"pose", "geometry\nvisual 1 sphere 1 2 0 0 0 0 1 0 0 0 0 1 0\nend_geometry\n", 2, 19,
                "no pose"},
        BadCase{"name", "names\nname 1 %zz\nend_names\n", 2, 8, "%20"},
        BadCase{"same name", "names\nname 1 2\nend_names\n", 2, 8, "another frame"},
        BadCase{"command", "names\nnames 1 a\nend_names\n", 2, 1, "did you mean name?"}));

}  // namespace mech_extras_test
}  // namespace abstand::robot_file
