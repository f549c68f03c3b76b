// Scenes that take their links and pairs from the files of a robot.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/scene_file/pair_selection.hpp"
#include "app/scene_file/scene_description.hpp"
#include "core/study/pairs_file.hpp"
#include "tests/support/paths.hpp"

namespace abstand::session {
namespace robot_scene_test {

// a: box; b: two collision bodies; c: only a visual one; d: none. b turns, c is fixed to it.
const char* const kRobot = R"(<robot name='r'>
<link name='a'><visual><geometry><mesh filename='nice.dae'/></geometry></visual>
<collision><geometry><box size='1 2 3'/></geometry></collision></link>
<link name='b'><visual><geometry><sphere radius='0.5'/></geometry></visual>
<collision><origin xyz='0 0 1'/><geometry><mesh filename='package://r/b.stl' scale='1 -1 2'/></geometry></collision>
<collision><geometry><cylinder radius='0.1' length='0.2'/></geometry></collision></link>
<link name='c'><visual><geometry><sphere radius='0.25'/></geometry></visual></link>
<link name='d'/>
<joint name='turn' type='continuous'><parent link='a'/><child link='b'/><axis xyz='0 0 1'/></joint>
<joint name='bc' type='fixed'><parent link='b'/><child link='c'/></joint>
<joint name='bd' type='fixed'><parent link='b'/><child link='d'/></joint>
</robot>)";

class RobotScene : public ::testing::Test {
 protected:
  RobotScene() {
    folder_.write("r.urdf", kRobot);
    std::filesystem::create_directories(folder_.path() / "r");
    folder_.write("r/b.stl", "x");
  }
  scene_file::SceneDescription parse(const std::string& mechanism, const std::string& rest = "") const {
    return scene_file::parseScene(
        "abstand: 1\nmechanisms:\n  - {name: m, file: r.urdf" + mechanism + "}\n" + rest,
        folder_.path() / "scene.yaml", {{}, false});
  }
  std::string refused(const std::string& mechanism, const std::string& rest = "") const {
    try {
      parse(mechanism, rest);
      return "was accepted";
    } catch (const ParseError& e) {
      return e.what();
    }
  }
  static std::vector<std::string> names(const scene_file::SceneDescription& s) {
    std::vector<std::string> n;
    for (const auto& l : s.mechanisms[0].links) n.push_back(l.name);
    return n;
  }

  testing::ScratchFolder folder_;
};

TEST_F(RobotScene, LinksComeFromRobotFile) {
  const auto s = parse(", margin: 0.1");
  EXPECT_EQ(names(s), (std::vector<std::string>{"m/a", "m/b", "m/b/2", "m/c"}));
  const auto& l = s.mechanisms[0].links;
  EXPECT_EQ(std::get<geometry::Cuboid>(*l[0].shape).size, Vector3d(1, 2, 3));
  EXPECT_EQ(l[1].mesh, folder_.path() / "r/b.stl");
  EXPECT_EQ(l[1].scale, Vector3d(1, -1, 2));
  EXPECT_EQ(l[1].X_FL.translation(), Vector3d(0, 0, 1));
  EXPECT_EQ(l[1].frame, "b");
  EXPECT_EQ(std::get<geometry::Sphere>(*l[3].shape).radius, 0.25);
  EXPECT_EQ(s.mechanisms[0].settings.margin, 0.1);
}

TEST_F(RobotScene, DescriptionRoundTrips) {
  const auto s = parse(", margin: 0.1");
  const std::string described = scene_file::describeScene(s);
  const auto again = scene_file::parseScene(described, folder_.path() / "scene.yaml", {{}, false});
  EXPECT_EQ(names(again), names(s));
  EXPECT_EQ(again.mechanisms[0].links[1].scale, Vector3d(1, -1, 2));
  EXPECT_EQ(scene_file::describeScene(again), described);
}

TEST_F(RobotScene, UsesVisualGeometryOnRequest) {
  const auto s = parse(", geometry: visual");
  EXPECT_EQ(names(s), (std::vector<std::string>{"m/a", "m/b", "m/c"}));
  EXPECT_TRUE(s.mechanisms[0].links[0].shape) << "nice.dae is missing: the collision box is taken";
  EXPECT_EQ(std::get<geometry::Sphere>(*s.mechanisms[0].links[1].shape).radius, 0.5);
  EXPECT_TRUE(std::any_of(s.remarks.begin(), s.remarks.end(), [](const std::string& r) {
    return r.find("some visual meshes") != std::string::npos && r.ends_with(": a");
  }));
}

TEST_F(RobotScene, LinksReferToNamedFrames) {
  const auto s = parse(
      ", links: [{name: x, frame: b, shape: {sphere: {radius: 1}}}, {name: y, frame: 0, shape: {sphere: "
      "{radius: 1}}}]");
  EXPECT_EQ(s.mechanisms[0].links[0].frame, "b");
  EXPECT_NE(refused(", links: [{name: x, frame: bb, shape: {sphere: {radius: 1}}}]")
                .find("scene.yaml:3:54: error: found `bb` for `frame`"),
            std::string::npos)
      << refused(", links: [{name: x, frame: bb, shape: {sphere: {radius: 1}}}]");
  EXPECT_NE(refused(", geometry: visual, links: []").find("together with `links`"), std::string::npos);
}

TEST_F(RobotScene, LinkWithoutGeometryIsMissingUnlessBodiless) {
  const char* const robot =
      "<robot name='r'><link name='a'><visual><geometry><mesh filename='a.dae'/></geometry></visual></link>"
      "<link name='b'><visual><geometry><mesh filename='b.dae'/></geometry></visual></link><link name='c'>"
      "<collision><geometry><sphere radius='1'/></geometry></collision></link><link name='frame'/>"
      "<joint name='ab' type='fixed'><parent link='a'/><child link='b'/></joint>"
      "<joint name='bc' type='fixed'><parent link='b'/><child link='c'/></joint>"
      "<joint name='cf' type='fixed'><parent link='c'/><child link='frame'/></joint></robot>";
  folder_.write("r.urdf", robot);
  const auto s = parse("");
  const scene_file::MechanismDescription& m = s.mechanisms[0];
  EXPECT_EQ(m.frames_with_geometry, 3u) << "a link without geometry is a frame";
  ASSERT_EQ(m.missing.size(), 2u);
  EXPECT_EQ(m.missing[1].frame, "b");
  EXPECT_EQ(m.missing[1].reason, "found no file b.dae");
  ASSERT_EQ(s.remarks.size(), 1u) << "one line for all";
  EXPECT_TRUE(s.remarks[0].starts_with("2 of 3 links of m have no body, or not all of it: a, b ("))
      << s.remarks[0];

  const auto one = parse(", bodiless: [a]");
  ASSERT_EQ(one.mechanisms[0].missing.size(), 1u);
  EXPECT_EQ(one.mechanisms[0].missing[0].frame, "b");
  EXPECT_EQ(scene_file::parseScene(scene_file::describeScene(one), folder_.path() / "scene.yaml")
                .mechanisms[0]
                .missing.size(),
            1u);
  EXPECT_TRUE(parse(", bodiless: [a, b]").mechanisms[0].missing.empty());
  const auto none = parse(", geometry: none");
  EXPECT_TRUE(none.mechanisms[0].links.empty() && none.mechanisms[0].missing.empty());
  EXPECT_TRUE(none.mechanisms[0].no_geometry);
  EXPECT_NE(refused(", bodiless: [d]").find("found `d` in `bodiless`"), std::string::npos);
}

TEST_F(RobotScene, LinkWithUnsupportedVisualOnlyIsMissing) {
  folder_.write("r.urdf",
                "<robot name='r'><link name='a'><visual><geometry><capsule radius='1' length='1'/></geometry>"
                "</visual></link><link name='b'><visual><geometry><capsule radius='1' length='1'/></geometry>"
                "</visual><collision><geometry><sphere radius='1'/></geometry></collision></link>"
                "<joint name='ab' type='fixed'><parent link='a'/><child link='b'/></joint></robot>");
  const auto s = parse("");
  const scene_file::MechanismDescription& m = s.mechanisms[0];
  EXPECT_EQ(m.frames_with_geometry, 2u);
  ASSERT_EQ(m.missing.size(), 1u);
  EXPECT_EQ(m.missing[0].frame, "a");
  EXPECT_NE(m.missing[0].reason.find("capsule"), std::string::npos) << m.missing[0].reason;
  EXPECT_TRUE(parse(", bodiless: [a]").mechanisms[0].missing.empty());
}

TEST_F(RobotScene, LinkCentrePlacesBody) {
  folder_.write("c.mech",
                "chain\nframe 1 0 0 0 theta\nframe 2 1 0 0 theta\nend_chain\n"
                "link\nid 1\ncenter 1 0 0 0.5  0 1 0 0  0 0 1 0.25\nend_link\n");
  folder_.write("rod.stl", "x");
  const auto link = [&](const std::string& text) {
    const auto s = scene_file::parseScene(
        "abstand: 1\nmechanisms:\n  - {name: m, file: c.mech, links: [{name: l, " + text + "}]}\n",
        folder_.path() / "scene.yaml", {{}, false});
    return s.mechanisms[0].links[0];
  };
  const std::string rod = "shape: {cuboid: {size: [1, 0.1, 0.1]}}";
  const Vector3d center(0.5, 0.0, 0.25);
  EXPECT_EQ(link("frame: 1, " + rod).X_FL.translation(), center) << "a shape's origin is its centre";
  EXPECT_EQ(link("frame: 1, pose: center, mesh: rod.stl").X_FL.translation(), center);
  EXPECT_EQ(link("frame: 1, mesh: rod.stl").X_FL.translation(), Vector3d::Zero())
      << "a mesh may stand in the axes of its frame";
  EXPECT_EQ(link("frame: 1, mesh: rod.stl").p_FC, center) << "which is looked at when it is loaded";
  EXPECT_EQ(link("frame: 1, pose: {xyz: [0, 0, 1]}, " + rod).X_FL.translation(), Vector3d(0, 0, 1));
  EXPECT_EQ(link("frame: 2, " + rod).X_FL.translation(), Vector3d::Zero());
  EXPECT_FALSE(link("frame: 2, " + rod).p_FC);
  EXPECT_THROW(link("frame: 2, pose: center, " + rod), ParseError);
}

TEST_F(RobotScene, ListsAllMissingCollisionMeshes) {
  folder_.write("bad.urdf",
                "<robot name='r'><link name='a'>\n<collision><geometry><mesh "
                "filename='package://p/m/a.stl'/></geometry></collision>"
                "<collision><geometry><mesh filename='m/b.stl'/></geometry></collision>"
                "<collision><geometry><mesh filename='m/b.stl'/></geometry></collision></link></robot>");
  try {
    scene_file::parseScene("abstand: 1\nmechanisms: [{name: m, file: bad.urdf}]\n", folder_.path() / "s.yaml",
                           {{}, false});
    FAIL() << "was accepted";
  } catch (const ParseError& e) {
    EXPECT_EQ(e.pos().line, 2);
    EXPECT_NE(e.message().find("2 collision meshes"), std::string::npos) << e.message();
    EXPECT_NE(e.message().find("package://p/m/a.stl, m/b.stl"), std::string::npos) << e.message();
    EXPECT_NE(std::string(e.what()).find("--package-path"), std::string::npos);
  }
}

TEST_F(RobotScene, SrdfExcludesPairsAndKeepsReason) {
  folder_.write("r.srdf",
                "<robot name='r'><disable_collisions link1='b' link2='a' reason='Never'/>"
                "<disable_collisions link1='a' link2='nobody' reason='User'/></robot>");
  const auto s = parse(", srdf: r.srdf");
  ASSERT_EQ(s.pairs.dropped.size(), 2u) << "both bodies of b";
  EXPECT_EQ(s.pairs.dropped[0].reason, "Never");
  std::vector<scene_file::SelectableBody> bodies;
  for (const auto& name : names(s)) bodies.push_back({name, "m"});
  EXPECT_EQ(scene_file::selectPairs(bodies, s.pairs, {}),
            (std::vector<std::pair<int, int>>{{0, 3}, {1, 2}, {1, 3}, {2, 3}}));
  EXPECT_EQ(scene_file::parseScene(scene_file::describeScene(s), folder_.path() / "scene.yaml")
                .pairs.dropped.size(),
            2u);
}

TEST_F(RobotScene, PairsFileExcludesPairs) {
  folder_.write(
      "r.pairs",
      "# by "
      "hand\nverdict,a,b,distance\nnever,m/a,m/b,0.5\nsometimes,m/a,m/c,-0.1\nuser,m/b,m/c\nnever,x,y\n");
  const auto s = parse("", "pairs: {file: r.pairs, include: [[m/b, m/c]]}\n");
  ASSERT_EQ(s.pairs.dropped.size(), 2u);
  EXPECT_EQ(s.pairs.dropped[0].reason, "never: 0.5");
  EXPECT_EQ(s.pairs.dropped[1].reason, "user");
  std::vector<scene_file::SelectableBody> bodies;
  for (const auto& name : names(s)) bodies.push_back({name, "m"});
  EXPECT_EQ(scene_file::selectPairs(bodies, s.pairs, {}),
            (std::vector<std::pair<int, int>>{{0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}));
  folder_.write("r.pairs", "verdict,a,b\nnever,x,y\n");
  EXPECT_NE(refused("", "pairs: {file: r.pairs}\n").find("no pair of bodies of this scene"),
            std::string::npos);
}

TEST(PairsFile, ReportsPositionOfErrors) {
  const struct {
    const char* text;
    int line;
    const char* says;
  } cases[] = {{"", 0, "no header"},
               {"# a\n", 0, "no header"},
               {"a,b\n", 1, "another header"},
               {"# x\nverdict,a,b\nnevr,a,b\n", 3, "did you mean never?"},
               {"verdict,a,b\nnever,a\n", 2, "no two bodies"},
               {"verdict,a,b\nnever,a,a\n", 2, "no two bodies"},
               {"verdict,a,b\nnever,a,\xff\n", 2, "UTF-8"}};
  for (const auto& c : cases) {
    SCOPED_TRACE(c.text);
    try {
      study::parsePairs(c.text, "t.pairs");
      FAIL() << "was read";
    } catch (const ParseError& e) {
      EXPECT_EQ(e.pos().line, c.line);
      EXPECT_NE(std::string(e.what()).find(c.says), std::string::npos) << e.what();
    }
  }
}

}  // namespace robot_scene_test
}  // namespace abstand::session
