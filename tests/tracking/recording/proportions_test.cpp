// Bones beside those of ANSUR II.
#include "tracking/recording/proportions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "humanmodel/human_model.hpp"
#include "tests/tracking/small_human.hpp"
#include "tracking/bvh/bvh_recording.hpp"

namespace abstand::tracking {
namespace proportions_test {

using humanmodel::BodyPart;
using humanmodel::Joint;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(Proportions, ModelIsInProportionAtAnyStature) {
  for (const double height : {1.2, 1.75, 2.1}) {
    humanmodel::HumanOptions options;
    options.height = height;
    const std::vector frames{humanmodel::makeHuman(options).rest};
    const auto bones = proportionsOf(frames);
    EXPECT_EQ(bones.size(), 10u);
    for (const auto& bone : bones) EXPECT_NEAR(bone.off(), 0.0, 0.02) << humanmodel::partName(bone.part);
    EXPECT_THAT(oddProportions(bones), IsEmpty());
  }
}

TEST(Proportions, ReportsLongForearm) {
  auto frame = humanmodel::makeHuman({}).rest;
  frame.set(Joint::kWristLeft,
            frame[Joint::kElbowLeft] + 1.4 * (frame[Joint::kWristLeft] - frame[Joint::kElbowLeft]));
  const auto bones = proportionsOf(std::vector{frame});
  for (const auto& bone : bones) EXPECT_EQ(bone.isOdd(), bone.part == BodyPart::kForearmLeft);
  EXPECT_THAT(oddProportions(bones), HasSubstr("forearm_left 40 % longer:"));
}

TEST(Proportions, IgnoreInferredJoints) {
  auto frame = humanmodel::makeHuman({}).rest;
  frame.set(Joint::kWristLeft, frame[Joint::kElbowLeft] * 3.0, humanmodel::JointState::kInferred);
  const auto bones = proportionsOf(std::vector{frame});
  EXPECT_EQ(bones.size(), 9u);
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
