// A joint that moves is stated to be less certain, for some time.
#include "tracking/tracker/joint_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/no_alloc.hpp"

namespace abstand::tracking {
namespace joint_motion_test {

constexpr double kRounding = 1e-12;  // m
constexpr std::size_t kHand = static_cast<std::size_t>(humanmodel::Joint::kHandLeft);

humanmodel::SkeletonFrame at(double x) {
  humanmodel::SkeletonFrame frame;
  for (Vector3d& p : frame.p) p.setZero();
  frame.p[kHand].x() = x;
  return frame;
}

/// What is left at `t` (s) of the unknown motion before the first frame at 0.
double unknownAt(double t) {
  return JointMotion::kTime * JointMotion::kUnknown * std::exp(-t / JointMotion::kDecay);
}

TEST(JointMotion, IsUnknownBeforeTheFirstImage) {
  JointMotion motion;
  motion.see(5.0, at(0.0));
  EXPECT_NEAR(motion.spread()[kHand], unknownAt(0.0), kRounding);
  motion.see(5.1, at(0.0));
  motion.see(5.2, at(0.0));
  EXPECT_NEAR(motion.spread()[kHand], unknownAt(0.2), kRounding);
}

TEST(JointMotion, IsProportionalToTheChangeOfVelocityAndDecays) {
  JointMotion motion;
  motion.see(0.0, at(0.0));
  motion.see(0.1, at(0.2));
  EXPECT_NEAR(motion.spread()[kHand], unknownAt(0.1), kRounding) << "the velocity before is unknown";
  motion.see(0.2, at(0.1));
  EXPECT_NEAR(motion.spread()[kHand], JointMotion::kTime * 3.0, kRounding) << "2 m/s, then -1 m/s";
  EXPECT_NEAR(motion.spread()[0], unknownAt(0.2), kRounding) << "a joint that stays";
  motion.see(0.2, at(0.9));
  EXPECT_NEAR(motion.spread()[kHand], JointMotion::kTime * 3.0, kRounding) << "the same time";
  motion.see(0.2 + 2.0 * JointMotion::kDecay, at(0.9));
  EXPECT_NEAR(motion.spread()[kHand], JointMotion::kTime * 3.0 * std::exp(-2.0), kRounding) << "a gap";
}

TEST(JointMotion, OfEvenMotionIsZero) {
  JointMotion motion;
  for (int i = 0; i <= 30; ++i) motion.see(0.1 * i, at(0.3 * i));
  EXPECT_NEAR(motion.spread()[kHand], unknownAt(3.0), kRounding);
}

TEST(JointMotion, ForgetsAPersonWhoWasLost) {
  JointMotion motion;
  motion.see(0.0, at(0.0));
  motion.see(0.1, at(0.5));
  motion.see(0.2, at(0.5));
  EXPECT_GT(motion.spread()[kHand], unknownAt(0.0));
  motion.forget();
  motion.see(0.3, at(2.0));
  motion.see(0.4, at(2.5));
  EXPECT_NEAR(motion.spread()[kHand], unknownAt(0.1), kRounding);
}

TEST(JointMotion, DoesNotAllocate) {
  JointMotion motion;
  const humanmodel::SkeletonFrame frame = at(0.0);
  const testing::NoAlloc guard;
  motion.see(0.0, frame);
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace joint_motion_test
}  // namespace abstand::tracking
