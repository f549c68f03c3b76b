// Bones beside those of ANSUR II.
#include "tracking/recording/proportions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "humanmodel/human_model.hpp"
#include "tests/tracking/small_human.hpp"
#include "tracking/bvh/bvh_recording.hpp"

namespace abstand::tracking {
namespace proportions_test {

using humanmodel::Joint;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(Proportions, ModelIsInProportionAtAnyStature) {
  for (const double height : {1.2, 1.75, 2.1}) {
    humanmodel::HumanOptions options;
    options.height = height;
    const std::vector frames{humanmodel::makeHuman(options).rest};
    const auto bones = proportionsOf(frames);
    EXPECT_EQ(bones.size(), 14u);
    for (const auto& bone : bones) {
      EXPECT_FALSE(bone.isOdd()) << bone.part << " " << bone.off();
      if (bone.longest == kOddProportion) {
        EXPECT_NEAR(bone.off(), 0.0, 0.02) << bone.part;
      }
    }
    EXPECT_THAT(oddProportions(bones), IsEmpty());
  }
}

TEST(Proportions, ReportsLongForearm) {
  auto frame = humanmodel::makeHuman({}).rest;
  frame.set(Joint::kWristLeft,
            frame[Joint::kElbowLeft] + 1.4 * (frame[Joint::kWristLeft] - frame[Joint::kElbowLeft]));
  const auto bones = proportionsOf(std::vector{frame});
  for (const auto& bone : bones) EXPECT_EQ(bone.isOdd(), bone.part == "forearm_left");
  EXPECT_THAT(oddProportions(bones), HasSubstr("forearm_left 40 % longer:"));
}

TEST(Proportions, ReportsBreadthsAndFeet) {
  const auto rest = humanmodel::makeHuman({}).rest;
  const auto oddOf = [&](Joint left, Joint right, const Vector3d& left_by, const Vector3d& right_by) {
    auto frame = rest;
    frame.set(left, frame[left] + left_by);
    frame.set(right, frame[right] + right_by);
    std::vector<std::string> odd;
    for (const auto& bone : proportionsOf(std::vector{frame}))
      if (bone.isOdd()) odd.push_back(bone.part);
    return odd;
  };
  using ::testing::Contains;
  const Vector3d out(0.0, 0.15, 0.0);
  const double shoulder = rest[Joint::kShoulderLeft].y(), hip = rest[Joint::kHipLeft].y();
  const Vector3d to_neck(0.0, 0.5 * shoulder, 0.0), to_middle(0.0, 0.9 * hip, 0.0);
  EXPECT_THAT(oddOf(Joint::kShoulderLeft, Joint::kShoulderRight, out, -out), Contains("shoulder_breadth"));
  EXPECT_THAT(oddOf(Joint::kShoulderLeft, Joint::kShoulderRight, -to_neck, to_neck),
              Contains("shoulder_breadth"));
  EXPECT_THAT(oddOf(Joint::kHipLeft, Joint::kHipRight, out, -out), Contains("hip_breadth"));
  EXPECT_THAT(oddOf(Joint::kHipLeft, Joint::kHipRight, -to_middle, to_middle), Contains("hip_breadth"));
  const Vector3d forward(0.25, 0.0, 0.0);
  EXPECT_THAT(oddOf(Joint::kToeLeft, Joint::kToeRight, forward, forward),
              ::testing::UnorderedElementsAre("foot_left", "foot_right"));
}

TEST(Proportions, IgnoreInferredJoints) {
  auto frame = humanmodel::makeHuman({}).rest;
  frame.set(Joint::kWristLeft, frame[Joint::kElbowLeft] * 3.0, humanmodel::JointState::kInferred);
  const auto bones = proportionsOf(std::vector{frame});
  EXPECT_EQ(bones.size(), 13u);
  EXPECT_THAT(oddProportions(bones), IsEmpty());
  EXPECT_THAT(proportionsOf({}), IsEmpty());
}

TEST(Proportions, AppearInReport) {
  const Recording r = readBvhRecording(testing::bvhOf({}), "t.bvh", {});
  EXPECT_GE(r.report.person.proportions.size(), 8u);
  for (const auto& bone : r.report.person.proportions) EXPECT_GT(bone.usual, 0.0);
}

}  // namespace proportions_test
}  // namespace abstand::tracking
