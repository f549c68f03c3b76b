// Motions that ask a slide for more than it may do.
#include "core/mechanism/motion_limits.hpp"

#include <gtest/gtest.h>

#include "core/robot_file/mech_file.hpp"

namespace abstand::mechanism {
namespace motion_limits_test {

const Vector3d kGravityZ(0, 0, -10);

/// A slide along z that carries 2 kg: within 1 m, 0.5 m/s, 0.8 m/s^2 and 21 N.
Mechanism slide(const std::string& more = "inertia\n body 1 2 0 0 0 0 0 0 0 0 0\nend_inertia\n") {
  return robot_file::parseMech(
             "chain\n frame 1 0 0 d 0\nend_chain\nlimits\n limit 1 -1 1 0.5 21 0.8\nend_limits\n" + more,
             "slide.mech")
      .mechanism;
}

std::vector<LimitBreach> breaches(const Mechanism& m, const MotionTable& motion, MotionLine line,
                                  double start, double end) {
  return motionBreaches(m, motion, line, start, end, kGravityZ);
}

void expectBreach(const LimitBreach& b, LimitKind kind, double value, double limit, double t, double since,
                  long count) {
  EXPECT_EQ(b.kind, kind);
  EXPECT_EQ(b.dof, 0);
  EXPECT_NEAR(b.value, value, 1e-9);
  EXPECT_NEAR(b.limit, limit, 1e-9);
  EXPECT_NEAR(b.t, t, 1e-9);
  EXPECT_NEAR(b.since, since, 1e-9);
  EXPECT_EQ(b.count, count);
}

TEST(MotionLimits, VelocityIsSlopeBetweenRows) {
  const Mechanism m = slide();
  // At 0.4 m/s, 0.6 m/s and -0.7 m/s.
  const MotionTable motion({0.0, 1.0, 3.0, 5.0}, {0.0, 0.4, 1.6, 0.2}, 1);
  const auto found = breaches(m, motion, MotionLine::kLinear, 0.0, 5.0);
  // Accelerations at the rows have no end, and are not looked at; nor are efforts.
  ASSERT_EQ(found.size(), 2u);
  expectBreach(found[0], LimitKind::kPosition, 1.6, 1.0, 3.0, 3.0, 2);
  expectBreach(found[1], LimitKind::kVelocity, -0.7, -0.5, 3.0, 1.0, 2);
}

TEST(MotionLimits, OnlyRequestedTimeCounts) {
  const Mechanism m = slide();
  const MotionTable motion({0.0, 1.0, 3.0}, {0.0, 0.4, 1.6}, 1);
  EXPECT_TRUE(breaches(m, motion, MotionLine::kLinear, 0.0, 1.0).empty());
  // At 2 s it is just at the end, but too fast.
  const auto before = breaches(m, motion, MotionLine::kLinear, 0.5, 2.0);
  ASSERT_EQ(before.size(), 1u);
  expectBreach(before[0], LimitKind::kVelocity, 0.6, 0.5, 1.0, 1.0, 1);
  // After the last row it rests where it is.
  const auto after = breaches(m, motion, MotionLine::kLinear, 4.0, 9.0);
  ASSERT_EQ(after.size(), 1u);
  expectBreach(after[0], LimitKind::kPosition, 1.6, 1.0, 4.0, 4.0, 1);
}

TEST(MotionLimits, SmoothMotionHasAccelerationsAndEfforts) {
  // From rest to rest over 0.6 m in 2 s: a = 6 d / T^2 (1 - 2 s) of s = t / T, v = 6 d / T (s - s^2).
  const MotionTable motion({0.0, 2.0}, {0.0, 0.6}, 1);
  const auto found = breaches(slide(), motion, MotionLine::kSmooth, 0.0, 2.0);
  ASSERT_EQ(found.size(), 2u);
  // It begins and ends with 0.9 m/s^2; of the efforts that are looked at, those at 0 and T / 8 are too large.
  expectBreach(found[0], LimitKind::kAcceleration, 0.9, 0.8, 0.0, 0.0, 2);
  expectBreach(found[1], LimitKind::kEffort, 2.0 * (10.0 + 0.9), 21.0, 0.0, 0.0, 2);
  // A robot without masses has no efforts.
  const auto weightless = breaches(slide(""), motion, MotionLine::kSmooth, 0.0, 2.0);
  ASSERT_EQ(weightless.size(), 1u);
  EXPECT_EQ(weightless[0].kind, LimitKind::kAcceleration);
  // In the middle it keeps all of them.
  EXPECT_TRUE(breaches(slide(""), motion, MotionLine::kSmooth, 0.5, 1.5).empty());
}

TEST(MotionLimits, LimitsApplyToDofNotJoint) {
  const Mechanism m = slide("mapping\n dof 0 1 0.2 -2\nend_mapping\n");
  // The joint's value is 0.2 - 2 q: q is within -0.4 and 0.6, and 0.25 /s.
  const MotionTable motion({0.0, 4.0}, {0.0, -0.5}, 1);
  const auto found = breaches(m, motion, MotionLine::kLinear, 0.0, 4.0);
  ASSERT_EQ(found.size(), 1u);
  expectBreach(found[0], LimitKind::kPosition, -0.5, -0.4, 4.0, 4.0, 1);
  const auto fast = breaches(m, MotionTable({0.0, 1.0}, {0.0, 0.3}, 1), MotionLine::kLinear, 0.0, 1.0);
  ASSERT_EQ(fast.size(), 1u);
  expectBreach(fast[0], LimitKind::kVelocity, 0.3, 0.25, 0.0, 0.0, 1);
}

}  // namespace motion_limits_test
}  // namespace abstand::mechanism
