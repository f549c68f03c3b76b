// Joints of points without a hierarchy, by their motion.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/tracking/joint_guess/guess_cases.hpp"
#include "tracking/joint_guess/name_guess.hpp"
#include "tracking/joint_guess/point_tree.hpp"
#include "tracking/registry/open_recording.hpp"

namespace abstand::tracking {
namespace joint_guess_test {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kSamePlace = 1e-6;  // units of a file

/// A figure whose joints turn at random, as points without a hierarchy in JSON lines. `turn`: degrees;
/// `rounding`: m.
std::string movingPoints(double turn, double rounding) {
  const Figure hand{{7, {0, 18, 0}, true}}, other_hand{{7, {0, -18, 0}, true}};
  std::string bvh = figureBvh(wholeFigure({hand, other_hand}));
  constexpr int kFrames = 100;
  bvh = bvh.substr(0, bvh.find("MOTION"));
  std::size_t joints = 0;
  const std::string none = "CHANNELS 0", three = "CHANNELS 3 Zrotation Xrotation Yrotation";
  for (auto at = bvh.find(none); at != std::string::npos; at = bvh.find(none, at), ++joints)
    bvh.replace(at, none.size(), three);
  bvh += "MOTION\nFrames: " + std::to_string(kFrames) + "\nFrame Time: 0.01\n";
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> angle(-turn, turn);
  for (int i = 0; i < kFrames; ++i) {
    bvh += "0 0 95";
    for (std::size_t k = 0; k < 3 * joints; ++k) bvh += " " + std::to_string(angle(random));
    bvh += "\n";
  }
  BvhPoints points(bvh, "t.bvh");
  std::string text;
  PointFrame frame;
  for (int i = 0; points.next(frame); ++i) {
    text += "{\"t\": " + std::to_string(0.01 * i) + ", \"joints\": {";
    for (std::size_t k = 0; k < frame.p.size(); ++k) {
      text += std::string(k == 0 ? "" : ", ") + "\"\xe9\xaa\xa8" + points.names()[k] + "\": [";
      for (int axis = 0; axis < 3; ++axis) {
        const double x = rounding * std::round(0.01 * frame.p[k][axis] / rounding);
        text += (axis == 0 ? "" : ", ") + std::to_string(x);
      }
      text += "]";
    }
    text += "}}\n";
  }
  return text;
}

TEST(JointGuess, PointsWithoutHierarchyAreGuessedByMotion) {
  const testing::ScratchFolder folder;
  for (const double rounding : {1e-6, 1e-3}) {
    const Recording r = openRecording(folder.write("a.jsonl", movingPoints(15.0, rounding)));
    EXPECT_EQ(r.report.joint_map, "guessed from the shape") << ::testing::PrintToString(r.report.notes);
    EXPECT_THAT(r.report.map_use.reason, HasSubstr("bones are distances that stay the same; two branches"));
    EXPECT_THAT(r.report.missing_parts, IsEmpty());
    const std::string bone = "\xe9\xaa\xa8";
    EXPECT_EQ(usedFor(r, humanmodel::Joint::kHipLeft), bone + "b2");
    EXPECT_EQ(usedFor(r, humanmodel::Joint::kKneeLeft), bone + "b3");
    EXPECT_EQ(usedFor(r, humanmodel::Joint::kAnkleRight), bone + "b8");
    EXPECT_EQ(usedFor(r, humanmodel::Joint::kShoulderLeft), bone + "b15");
    EXPECT_EQ(usedFor(r, humanmodel::Joint::kWristRight), bone + "b21");
  }
  const Recording still = openRecording(folder.write("still.jsonl", movingPoints(0.0, 1e-6)));
  EXPECT_THAT(still.report.mapped, IsEmpty());
  EXPECT_THAT(still.report.notes, Contains(HasSubstr("its points do not move relative to each other")));
}

// Without the hierarchy, bones are distances that stay the same.
TEST_P(RealShape, PointsWithoutHierarchyMatchNames) {
  using J = humanmodel::Joint;
  BvhPoints points(text, name);
  const JointMatch named = matchByNames(points);
  std::vector<PointFrame> frames;
  for (PointFrame frame; frames.size() < 600 && points.next(frame);) frames.push_back(frame);
  const std::vector<std::string> names(points.names().size(), "n");
  const ShapeGuess guess = guessByMotion(names, frames);
  ASSERT_EQ(limbJoints(guess.match), 12) << guess.reason;
  for (auto j = static_cast<std::size_t>(J::kShoulderLeft); j < humanmodel::kJointCount; ++j) {
    if ((j - 6) % 4 == 3) continue;
    // Of points at the same place any may be used; files round their lengths.
    const auto found = static_cast<std::size_t>(guess.match.joint[j]),
               expected = static_cast<std::size_t>(named.joint[j]);
    EXPECT_NEAR((frames.front().p[found] - frames.front().p[expected]).norm(), 0.0, kSamePlace)
        << humanmodel::jointName(static_cast<J>(j));
  }
}

}  // namespace joint_guess_test
}  // namespace abstand::tracking
