// What a mechanism file says, and that it is understood to the letter.
#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "core/base/text_file.hpp"
#include "core/robot_file/mech_file.hpp"
#include "tests/support/paths.hpp"

namespace abstand::robot_file {
namespace mech_file_test {

// Rounding of a few products.
constexpr double kExact = 1e-14;

TEST(MechFile, ReadsThesisExample) {
  const mechanism::Mechanism m = loadMechanism(testing::projectFile("data/scenes/example.mech"));
  EXPECT_EQ(m.name, "example");
  ASSERT_EQ(m.frames.size(), 4u);
  EXPECT_EQ(m.dof, 3);
  EXPECT_EQ(m.frames[0].type, mechanism::JointType::kRevolute);
  EXPECT_EQ(m.frames[1].type, mechanism::JointType::kPrismatic);
  EXPECT_EQ(m.frames[2].type, mechanism::JointType::kRevolute);
  EXPECT_EQ(m.frames[3].type, mechanism::JointType::kFixed);
  EXPECT_EQ(m.frames[3].dof, -1);
  EXPECT_NEAR(m.frames[1].a, 0.24, kExact);
  EXPECT_NEAR(m.frames[2].alpha, kPi / 2, kExact);
  EXPECT_NEAR(m.frames[3].a, 0.16, kExact);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(m.frames[static_cast<std::size_t>(i)].parent, i - 1);
}

TEST(MechFile, ReadsThesisChainWithLinks) {
  const mechanism::Mechanism m = loadMechanism(testing::projectFile("data/scenes/chain.mech"));
  ASSERT_EQ(m.frames.size(), 3u);
  EXPECT_EQ(m.dof, 3);
  for (const auto& f : m.frames) {
    EXPECT_TRUE(f.has_center);
    EXPECT_EQ(f.X_FC.translation(), Vector3d(0.5, 0, 0));
    EXPECT_TRUE(f.X_FC.linear().isIdentity(kExact));
  }
}

struct UnitCase {
  const char* words;
  double length, angle;
};
class MechUnits : public ::testing::TestWithParam<UnitCase> {};

TEST_P(MechUnits, ConvertEveryLengthAndAngle) {
  const auto& c = GetParam();
  const std::string text = std::string(c.words) +
                           "chain\nframe 1 2 3 4 theta\nframe 2 2 3 d 5\nframe 3 2 3 4 5\nend_chain\n"
                           "mapping\ndof 0 1 6 1\ndof 1 2 6 -2\nend_mapping\n"
                           "link\nid 3\ncenter 1 0 0 7  0 1 0 8  0 0 1 9\nend_link\n";
  const mechanism::Mechanism m = parseMechanism(text, "units.mech");
  EXPECT_NEAR(m.frames[0].a, 2 * c.length, kExact);
  EXPECT_NEAR(m.frames[0].alpha, 3 * c.angle, kExact);
  EXPECT_NEAR(m.frames[0].d, 4 * c.length, kExact);
  EXPECT_NEAR(m.frames[0].offset, 6 * c.angle, kExact);
  EXPECT_NEAR(m.frames[1].theta, 5 * c.angle, kExact);
  EXPECT_NEAR(m.frames[1].offset, 6 * c.length, kExact);
  EXPECT_EQ(m.frames[1].scale, -2.0);
  EXPECT_TRUE(m.frames[2].X_FC.translation().isApprox(c.length * Vector3d(7, 8, 9), kExact));
}

INSTANTIATE_TEST_SUITE_P(
    All, MechUnits,
    ::testing::Values(UnitCase{"", 1.0, 1.0}, UnitCase{"units\nend_units\n", 1.0, 1.0},
                      UnitCase{"units\nlength m\nangle radians\nend_units\n", 1.0, 1.0},
                      UnitCase{"units\nlength mm\nend_units\n", 0.001, 1.0},
                      UnitCase{"units\nlength cm\nangle degrees\nend_units\n", 0.01, kPi / 180},
                      UnitCase{"units\nangle degrees\nlength inches\nend_units\n", 0.0254, kPi / 180}));

TEST(MechFile, ReadsCommentsWhitespaceAndAnySectionOrder) {
  const mechanism::Mechanism m = parseMechanism(
      "# first\r\n\r\nmapping # of all\r\n\t#dof 0 9\r\n\tdof\t0   2#tight\r\n dof 1 1\r\nend_mapping\r\n"
      "chain\r\nreference 0\r\nframe 1 0 0 0 theta\r\nend_chain\r\nchain\r\nreference 1\r\nframe 2 0 0 d "
      "0\r\n"
      "end_chain\r\nunits\r\nend_units # last, without a line break",
      "a.mech");
  EXPECT_EQ(m.dof, 2);
  EXPECT_EQ(m.frames[0].dof, 1);
  EXPECT_EQ(m.frames[1].dof, 0);
  EXPECT_EQ(m.frames[1].parent, 0);
}

TEST(MechFile, BranchesAtReferences) {
  const mechanism::Mechanism m = parseMechanism(
      "chain\nframe 7 1 0 0 theta\nframe 3 1 0 0 theta\nend_chain\n"
      "chain\nreference 7\nframe 5 0 0 1 0\nend_chain\nchain\nframe 9 0 0 0 0\nend_chain\n",
      "tree.mech");
  EXPECT_EQ(m.frames[1].parent, m.indexOf(7));
  EXPECT_EQ(m.frames[2].parent, m.indexOf(7));
  EXPECT_EQ(m.frames[3].parent, -1);
  EXPECT_EQ(m.indexOf(8), -1);
}

TEST(MechFile, NumbersVariablesInFileOrderWithoutMapping) {
  const mechanism::Mechanism m = parseMechanism(
      "chain\nframe 5 0 0 0 theta\nframe 4 0 0 0 0\nframe 2 0 0 d 0\nend_chain\n", "plain.mech");
  EXPECT_EQ(m.dof, 2);
  EXPECT_EQ(m.frames[0].dof, 0);
  EXPECT_EQ(m.frames[1].dof, -1);
  EXPECT_EQ(m.frames[2].dof, 1);
}

TEST(MechFile, OrthonormalizesRoundedRotation) {
  const mechanism::Mechanism m = parseMechanism(
      "chain\nframe 1 0 0 0 theta\nend_chain\nlink\nid 1\ncenter 0.7071 -0.7071 0 1 0.7071 0.7071 0 2 0 0 1 "
      "3\n"
      "end_link\n",
      "rounded.mech");
  EXPECT_TRUE(isPose(m.frames[0].X_FC, 1e-12));
  EXPECT_NEAR(m.frames[0].X_FC.linear()(0, 0), std::sqrt(0.5), 1e-4) << "four digits were given";
}

TEST(MechFile, LwrArmReachesStraightUp) {
  const mechanism::Mechanism m = loadMechanism(testing::projectFile("data/robots/lwr/lwr4.mech"));
  EXPECT_EQ(m.dof, 7);
  mechanism::MechanismState state;
  const std::vector<double> zero(7, 0.0);
  mechanism::forward(m, zero, state);
  // Sum of the offsets d1, d3, d5 and d7 of the maker's table.
  EXPECT_TRUE(state.X_BF.back().translation().isApprox(Vector3d(0, 0, 0.3105 + 0.4 + 0.39 + 0.078), kExact));
  EXPECT_TRUE(state.X_BF.back().linear().isIdentity(kExact));
  for (const auto& f : m.frames) EXPECT_TRUE(f.has_center) << f.id;
}

TEST(MechFile, FuzzerCorpusIsReadOrRejected) {
  int files = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(testing::projectFile("tests/fuzz/corpus/mech"))) {
    SCOPED_TRACE(entry.path());
    ++files;
    try {
      const mechanism::Mechanism m = loadMechanism(entry.path());
      mechanism::MechanismState state;
      mechanism::forward(m, std::vector<double>(static_cast<std::size_t>(m.dof), 0.5), state);
      for (const auto& X_BF : state.X_BF) EXPECT_TRUE(isPose(X_BF));
    } catch (const ParseError& e) {
      EXPECT_EQ(e.pos().file, entry.path().string());
    }
  }
  EXPECT_GT(files, 0);
}

}  // namespace mech_file_test
}  // namespace abstand::robot_file
