// Braking paths: closed forms and their consistency.
#include "core/safety/braking_path.hpp"

#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "core/math/random.hpp"
#include "tests/support/no_alloc.hpp"

namespace abstand::safety {
namespace braking_path_test {

constexpr double kExact = 1e-12;
// Central difference over 1e-6 s of a path with accelerations of some 10 rad/s^2.
constexpr double kStep = 1e-6, kSlope = 1e-4;

TEST(BrakingPath, SingleJointMatchesClosedForm) {
  BrakingPath path({.deceleration = {4.0}, .reaction_time = 0.1}, 1);
  const double q[] = {0.5}, qd[] = {-2.0};
  ASSERT_TRUE(path.start(q, qd));
  // 0.2 rad in the reaction time, then v^2 / 2a = 0.5 rad within 0.5 s.
  EXPECT_NEAR(path.stopTime(), 0.6, kExact);
  EXPECT_NEAR(path.brakingDistance(0), -0.7, kExact);
  EXPECT_NEAR(path.q(0, 0.1), 0.3, kExact);
  EXPECT_NEAR(path.qd(0, 0.1), -2.0, kExact);
  EXPECT_NEAR(path.qd(0, 0.35), -1.0, kExact);
  EXPECT_NEAR(path.q(0, 99.0), -0.2, kExact);
  EXPECT_EQ(path.qd(0, 99.0), 0.0);
  EXPECT_EQ(path.fastest(0, 0.0), 2.0);
  EXPECT_NEAR(path.fastest(0, 0.35), 1.0, kExact);
}

TEST(BrakingPath, TogetherStaysOnLineInJointSpace) {
  BrakingPath path({.deceleration = {4.0, 2.0, 8.0}, .kind = BrakingKind::kTogether}, 3);
  const double q[] = {0.0, 1.0, 2.0}, qd[] = {2.0, -2.0, 0.0};
  ASSERT_TRUE(path.start(q, qd));
  // The second joint needs 1 s; the others take as long.
  EXPECT_NEAR(path.stopTime(), 1.01, kExact);
  EXPECT_NEAR(path.deceleration(0), 2.0, kExact);
  for (double t = 0.0; t < 1.5; t += 0.05) {
    EXPECT_NEAR(path.q(0, t), -(path.q(1, t) - 1.0), kExact);
    EXPECT_EQ(path.q(2, t), 2.0);
  }
}

TEST(BrakingPath, VelocityIsSlopeAndNeverGrows) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(5, seed);
    std::vector<double> q(7), qd(7), a(7);
    for (int i = 0; i < 7; ++i) {
      q[i] = random.between(-3, 3);
      qd[i] = random.between(-2, 2);
      a[i] = random.between(0.5, 20);
    }
    BrakingPath path(
        {a, random.between(0.0, 0.1), seed % 2 ? BrakingKind::kTogether : BrakingKind::kEachJoint}, 7);
    ASSERT_TRUE(path.start(q, qd));
    std::vector<double> before(7), after(7);
    for (int k = 0; k < 20; ++k) {
      const double t = random.between(kStep, 1.2 * path.stopTime());
      path.at(t - kStep, before);
      path.at(t + kStep, after);
      for (int i = 0; i < 7; ++i) {
        ASSERT_NEAR((after[i] - before[i]) / (2 * kStep), path.qd(i, t), kSlope);
        ASSERT_LE(path.fastest(i, t), path.fastest(i, 0.5 * t));
        ASSERT_LE(path.deceleration(i), a[i] * (1.0 + kExact));
      }
    }
    for (int i = 0; i < 7; ++i) {
      ASSERT_NEAR(path.qd(i, path.stopTime(i)), 0.0, kExact);
      ASSERT_LE(path.stopTime(i), path.stopTime() + kExact);
    }
  }
}

TEST(BrakingPath, ReportsNonFiniteValues) {
  BrakingPath path({}, 2);
  const double q[] = {0.0, 1.0}, bad[] = {kNaN, 1.0};
  EXPECT_FALSE(path.start(q, bad));
  EXPECT_EQ(path.stopTime(), 0.0);
  EXPECT_EQ(path.q(1, 5.0), 1.0);
  EXPECT_FALSE(path.start(bad, q));
}

TEST(BrakingPath, RejectsBadOptions) {
  EXPECT_THROW(BrakingPath({.deceleration = {0.0}}, 1), UsageError);
  EXPECT_THROW(BrakingPath({.deceleration = {1.0, 2.0}}, 3), UsageError);
  EXPECT_THROW(BrakingPath({.reaction_time = -1.0}, 1), UsageError);
}

TEST(BrakingPath, AllocatesNothing) {
  BrakingPath path({}, 7);
  std::vector<double> q(7, 0.1), qd(7, 1.0), at(7);
  const testing::NoAlloc guard;
  for (int i = 0; i < 100; ++i) {
    path.start(q, qd);
    path.at(0.01 * i, at);
  }
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace braking_path_test
}  // namespace abstand::safety
