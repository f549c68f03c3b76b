// Joints by their names, and what a joint map lacks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "core/base/error.hpp"
#include "tests/tracking/joint_guess/guess_cases.hpp"
#include "tests/tracking/small_human.hpp"
#include "tracking/joint_guess/guess_fill.hpp"
#include "tracking/recording/joint_map_writer.hpp"
#include "tracking/recording/required_person.hpp"

namespace abstand::tracking {
namespace joint_guess_test {

using testing::bvhOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TEST(JointGuess, ReadsNamesWithUnknownPrefixes) {
  const Recording plain = read(bvhOf({}));
  const Recording r =
      read(bvhOf({.rename = [](const std::string& n) { return "Ch7_rig_" + n + "_jnt.003"; }}));
  EXPECT_EQ(r.report.joint_map, "guessed from the names");
  EXPECT_TRUE(r.report.map_use.is_guess);
  EXPECT_THAT(r.report.missing_parts, IsEmpty());
  EXPECT_EQ(limbsApart(plain, r), 0.0);
  EXPECT_THAT(r.report.warnings, Contains(HasSubstr("the joint assignment is guessed: 12 of 12")));
}

TEST(JointGuess, UserMapTakesPrecedence) {
  const testing::ScratchFolder folder;
  const auto map = folder.write("own.map", "name: Own\npelvis: bone0\n");
  const Recording r =
      read(renamed(bvhOf({}), [](int i) { return "bone" + std::to_string(i); }), {.joint_map = map});
  EXPECT_EQ(r.report.joint_map, "Own");
  EXPECT_FALSE(r.report.map_use.is_guess);
  EXPECT_THROW(requirePerson(r.report, "t.bvh"), ParseError);
}

TEST(JointGuess, MisspeltNamesOfUserMapAreReported) {
  const testing::ScratchFolder folder;
  const Recording r = read(
      bvhOf({}), {.joint_map = folder.write("own.map", "name: Own\npelvis: Hips\nelbow_left: LeftElbov\n")});
  EXPECT_THAT(r.report.warnings,
              Contains("the joint map names joints that the file does not have: elbow_left "
                       "'LeftElbov' (nearest: 'LeftElbow')"));
}

TEST(JointGuess, IgnoresNamesOfImpossibleLimbs) {
  // The left calf begins at the ankle: left and right differ.
  const Recording plain = read(bvhOf({}));
  const Recording r = read(bvhOf({.rename = [](const std::string& n) {
    return "q_" + (n == "LeftKnee" ? "LeftAnkle" : n == "LeftAnkle" ? "LeftKnee" : n) + "_q";
  }}));
  EXPECT_THAT(r.report.notes,
              Contains(HasSubstr("the legs that the names suggest are not used: left and right")));
  EXPECT_EQ(r.report.joint_map, "guessed from the shape");
  EXPECT_EQ(limbsApart(plain, r), 0.0);
}

/// Names of sides and segments; in `names` those that differ from them.
std::string sidedName(const std::string& n, const std::map<std::string, std::string>& names) {
  if (const auto it = names.find(n); it != names.end()) return it->second;
  const bool is_left = n.starts_with("Left"), is_right = n.starts_with("Right");
  if (!is_left && !is_right) return n;
  const std::map<std::string, std::string> segments{
      {"Collar", "collar"}, {"Shoulder", "upperarm"}, {"Elbow", "forearm"}, {"Wrist", "hand"},
      {"Hip", "thigh"},     {"Knee", "shin"},         {"Ankle", "foot"}};
  return (is_left ? "l_" : "r_") + segments.at(n.substr(is_left ? 4 : 5));
}

TEST(JointGuess, JointsThatAMapLacksAreGuessedByNames) {
  const Recording plain = read(bvhOf({}));
  const Recording r = read(bvhOf({.rename = [](const std::string& n) { return sidedName(n, {}); }}));
  EXPECT_EQ(r.report.joint_map, "3ds Max Biped");
  EXPECT_TRUE(r.report.map_use.is_guess);
  EXPECT_THAT(r.report.missing_parts, IsEmpty());
  EXPECT_EQ(limbsApart(plain, r), 0.0);
  EXPECT_THAT(
      r.report.warnings,
      Contains(HasSubstr("joints that the map lacks are guessed: knee_left 'l_shin', knee_right 'r_shin', "
                         "pelvis 'Hips' by the names; check")));
  EXPECT_THAT(r.report.map_use.reason, HasSubstr("; guessed: knee_left 'l_shin'"));
  const testing::ScratchFolder folder;
  const Recording again = read(bvhOf({.rename = [](const std::string& n) { return sidedName(n, {}); }}),
                               {.joint_map = folder.write("own.map", jointMapText(r.report))});
  EXPECT_EQ(again.report.map_use.names, r.report.map_use.names);
}

TEST(JointGuess, JointsThatAMapLacksAreGuessedByShape) {
  const Recording plain = read(bvhOf({}));
  const Recording r = read(bvhOf({.rename = [](const std::string& n) {
    return sidedName(n, {{"LeftKnee", "n1"}, {"RightKnee", "n2"}, {"Hips", "Pelvis"}});
  }}));
  EXPECT_EQ(r.report.joint_map, "3ds Max Biped");
  EXPECT_THAT(r.report.missing_parts, IsEmpty());
  EXPECT_EQ(limbsApart(plain, r), 0.0);
  EXPECT_THAT(r.report.warnings, Contains(HasSubstr("knee_left 'n1', knee_right 'n2' by the shape")));
}

TEST(JointGuess, MapThatFindsAllLimbsIsNotGuessed) {
  const Recording r = read(bvhOf({}));
  EXPECT_FALSE(r.report.map_use.is_guess);
  EXPECT_THAT(r.report.warnings, Not(Contains(HasSubstr("guessed"))));
}

TEST(JointGuess, FillsOnlyWhatAgrees) {
  using J = humanmodel::Joint;
  const auto at = [](const JointMatch& m, J j) { return m.joint[static_cast<std::size_t>(j)]; };
  const auto set = [](JointMatch& m, J j, int i) { m.joint[static_cast<std::size_t>(j)] = i; };
  JointMatch guess;
  guess.joint.fill(-1);
  int next = 0;
  for (auto j = static_cast<std::size_t>(J::kShoulderLeft); j < humanmodel::kJointCount; ++j)
    guess.joint[j] = next++;
  JointMatch none;
  none.joint.fill(-1);
  for (const J j : {J::kHipLeft, J::kHipRight, J::kShoulderLeft, J::kShoulderRight})
    set(none, j, at(guess, j));

  JointMatch agrees = none;
  EXPECT_EQ(fillFrom(agrees, guess).size(), 12u);
  EXPECT_EQ(agrees.joint, guess.joint);
  JointMatch other_knee = none;
  set(other_knee, J::kKneeLeft, 99);
  EXPECT_EQ(fillFrom(other_knee, guess).size(), 6u) << "arms only";
  EXPECT_EQ(at(other_knee, J::kAnkleLeft), -1);
  JointMatch crossed = none;
  set(crossed, J::kHipLeft, at(guess, J::kHipRight));
  set(crossed, J::kHipRight, -1);
  EXPECT_THAT(fillFrom(crossed, guess), IsEmpty());
}

// The name of a root on the floor says pelvis, as far as names go.
TEST(JointGuess, RootOnFloorIsNoPelvis) {
  for (const double root : {0.0, 0.9}) {
    const std::vector<std::string> names{"root",   "thigh_l",    "calf_l",     "foot_l",     "thigh_r",
                                         "calf_r", "foot_r",     "neck",       "upperarm_l", "lowerarm_l",
                                         "hand_l", "upperarm_r", "lowerarm_r", "hand_r"};
    PointFrame frame;
    frame.p = {{0, 0, root},   {0, 0.1, 0.9},  {0, 0.1, 0.5},  {0, 0.1, 0.1},  {0, -0.1, 0.9},
               {0, -0.1, 0.5}, {0, -0.1, 0.1}, {0, 0, 1.45},   {0, 0.2, 1.4},  {0, 0.2, 1.1},
               {0, 0.2, 0.85}, {0, -0.2, 1.4}, {0, -0.2, 1.1}, {0, -0.2, 0.85}};
    frame.state.assign(names.size(), humanmodel::JointState::kTracked);
    const JointChoice choice = chooseJoints({names, {}, {}, {&frame, 1}}, {}, true);
    EXPECT_EQ(choice.match.joint[static_cast<std::size_t>(humanmodel::Joint::kPelvis)], root > 0.0 ? 0 : -1);
    EXPECT_EQ(choice.filled, root > 0.0 ? "pelvis 'root' by the names" : "");
  }
}

}  // namespace joint_guess_test
}  // namespace abstand::tracking
