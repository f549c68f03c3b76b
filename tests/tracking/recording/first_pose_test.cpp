// T-poses before a movement are named, and nothing else is.
#include "tracking/recording/first_pose.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "humanmodel/human_model.hpp"
#include "tests/support/paths.hpp"
#include "tracking/recording/recording.hpp"
#include "tracking/registry/open_recording.hpp"

namespace abstand::tracking {
namespace first_pose_test {

using humanmodel::Joint;
using humanmodel::SkeletonFrame;
using ::testing::Contains;
using ::testing::HasSubstr;

/// The standing model with its arms raised sideways by `angle` from hanging, rad.
SkeletonFrame raised(double angle) {
  SkeletonFrame f = humanmodel::makeHuman({}).rest;
  for (const double side : {1.0, -1.0}) {
    const auto at = [&](Joint left) {
      return static_cast<Joint>(static_cast<int>(left) + (side > 0 ? 0 : 4));
    };
    const Vector3d along(0.0, side * std::sin(angle), -std::cos(angle));
    f.set(at(Joint::kElbowLeft), f[at(Joint::kShoulderLeft)] + 0.3 * along);
    f.set(at(Joint::kWristLeft), f[at(Joint::kShoulderLeft)] + 0.55 * along);
  }
  return f;
}

TEST(FirstPose, TPoseIsLeftInNextFrame) {
  const SkeletonFrame t = raised(0.5 * kPi), hanging = raised(0.1);
  const auto turned = leadingTPose(std::vector{t, hanging, hanging});
  ASSERT_TRUE(turned);
  EXPECT_NEAR(*turned, 0.5 * kPi - 0.1, 1e-9);
  EXPECT_FALSE(leadingTPose(std::vector{t, raised(0.47 * kPi)})) << "a movement that begins so";
  EXPECT_FALSE(leadingTPose(std::vector{hanging, t}));
  EXPECT_FALSE(leadingTPose(std::vector{raised(0.3 * kPi), hanging})) << "an A-pose";
  EXPECT_FALSE(leadingTPose(std::vector{t}));
  EXPECT_FALSE(leadingTPose({}));
  SkeletonFrame bent = t;
  bent.set(Joint::kAnkleLeft, bent[Joint::kKneeLeft] + Vector3d(-0.4, 0.0, 0.0));
  EXPECT_FALSE(leadingTPose(std::vector{bent, hanging}));
  EXPECT_FALSE(leadingTPose(std::vector{SkeletonFrame{}, hanging}));
}

/// The conversion of the CMU data base begins with one.
TEST(FirstPose, RealTPosesAreReported) {
  const auto file = testing::debianBvh("01_01.bvh");
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
  EXPECT_THAT(openRecording(file).report.notes, Contains(HasSubstr("the first frame is a T-pose")));
  const auto walk = testing::sharedData("mocap/bvh/bvhtoolbox_walk01.bvh");
  if (!std::filesystem::exists(walk)) GTEST_SKIP() << walk;
  EXPECT_THAT(openRecording(walk).report.notes, ::testing::Not(Contains(HasSubstr("T-pose"))));
}

}  // namespace first_pose_test
}  // namespace abstand::tracking
