// Speed and separation monitoring: numbers computed by hand, and the inverse.
#include "core/safety/protective_distance.hpp"

#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "tests/support/random_pose.hpp"

namespace abstand::safety {
namespace protective_distance_test {

using testing::randomUnit;

constexpr double kExact = 1e-12;  // sums of a few products near 1
// Halvings of the wanted speed stop at one part in 10^9.
constexpr double kHalved = 1e-8;

SeparationOptions example(double person_speed) {
  SeparationOptions o;
  o.reaction_time = 0.1;
  o.stopping_time = 0.3;
  o.intrusion = 0.2;
  o.person_error = 0.1;
  o.robot_error = 0.05;
  o.person_speed = o.person_speed_near = person_speed;
  return o;
}

TEST(ProtectiveDistance, MatchesWorkedExamples) {
  struct Case {
    double person, robot, expected;
  };
  // S_p = v_h (T_r + T_s) + v_r T_r + v_r T_s / 2 + C + Z_d + Z_r.
  for (const Case& c : {Case{1.6, 1.0, 1.240}, Case{2.0, 1.0, 1.400}, Case{1.6, 0.25, 1.0525},
                        Case{1.6, 2.0, 1.490}, Case{1.6, 0.0, 0.990}})
    EXPECT_NEAR(protectiveDistance(example(c.person), c.robot, kNaN, 5.0).sum(), c.expected, kExact)
        << c.person << " " << c.robot;
}

TEST(ProtectiveDistance, ReportsTerms) {
  const ProtectiveDistance s = protectiveDistance(example(1.6), 1.0, kNaN, 5.0);
  EXPECT_NEAR(s.person, 0.64, kExact);
  EXPECT_NEAR(s.reaction, 0.1, kExact);
  EXPECT_NEAR(s.stopping, 0.15, kExact);
  EXPECT_NEAR(s.constant, 0.35, kExact);
  // A robot that goes away counts as standing, no less.
  EXPECT_NEAR(protectiveDistance(example(1.6), -1.0, kNaN, 5.0).sum(), 0.990, kExact);
}

TEST(ProtectiveDistance, StoppingTimeFollowsSpeed) {
  SeparationOptions o = example(1.6);
  o.deceleration = 4.0;
  // T_s = 0.25 s at 1 m/s: 1.6 * 0.35 + 0.1 + 0.125 + 0.35; T_s = 0 when it stands.
  EXPECT_NEAR(protectiveDistance(o, 1.0, kNaN, 5.0).sum(), 1.135, kExact);
  EXPECT_NEAR(protectiveDistance(o, 0.0, kNaN, 5.0).sum(), 0.51, kExact);
}

TEST(ProtectiveDistance, UsesHandSpeedAtCloseRange) {
  const SeparationOptions o;
  EXPECT_EQ(assumedPersonSpeed(o, 0.6), 1.6);
  EXPECT_EQ(assumedPersonSpeed(o, 0.4), 2.0);
  EXPECT_EQ(assumedPersonSpeed(o, kNaN), 2.0);
}

TEST(ProtectiveDistance, MeasuredSpeedsOnlyShortenIt) {
  SeparationOptions o = example(1.6);
  o.person_acceleration = 2.0;
  const double unknown = protectiveDistance(o, 1.0, kNaN, 5.0).person;
  // Standing, for 0.4 s at 2 m/s^2: 0.16 m. Going away at 1 m/s: not back within 0.4 s.
  EXPECT_NEAR(protectiveDistance(o, 1.0, 0.0, 5.0).person, 0.16, kExact);
  EXPECT_EQ(protectiveDistance(o, 1.0, -1.0, 5.0).person, 0.0);
  for (double v = -3.0; v < 3.0; v += 0.05)
    EXPECT_LE(protectiveDistance(o, 1.0, v, 5.0).person, unknown + kExact);
  EXPECT_NEAR(protectiveDistance(o, 1.0, 9.0, 5.0).person, unknown, kExact) << "faster than is believed";
}

TEST(PermittedSpeed, IsInverseOfProtectiveDistance) {
  int inner = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE(seed);
    const auto u = [&](std::uint64_t stream) { return randomUnit(seed, stream); };
    SeparationOptions o;
    o.reaction_time = 0.3 * u(0);
    o.stopping_time = 0.5 * u(1);
    o.deceleration = seed % 2 ? 0.5 + 5.0 * u(2) : 0.0;
    o.intrusion = 0.3 * u(3);
    o.person_acceleration = seed % 3 ? 0.0 : 10.0 * u(4);
    const double wanted = 2.0 * u(5), distance = 3.0 * u(6), person = seed % 5 ? kNaN : 4.0 * u(7) - 2.0;
    const double v = permittedSpeed(o, wanted, person, distance);
    ASSERT_GE(v, 0.0);
    ASSERT_LE(v, wanted);
    if (v > 0.0) {
      ASSERT_LE(protectiveDistance(o, v, person, distance).sum(), distance + kExact);
    }
    // A little more would be too much.
    if (v < wanted) {
      ASSERT_GE(protectiveDistance(o, v + kHalved, person, distance).sum(), distance);
      inner += v > 0.0;
    }
  }
  EXPECT_GT(inner, 300);
}

TEST(SeparationOptions, RejectOutOfRangeValues) {
  SeparationOptions o;
  o.reaction_time = -0.1;
  try {
    o.validate();
    FAIL();
  } catch (const UsageError& e) {
    EXPECT_STREQ(e.what(), "separation.reaction_time -0.1: expected a number from 0 to 10 s");
  }
  o.reaction_time = kNaN;
  EXPECT_THROW(o.validate(), UsageError);
}

}  // namespace protective_distance_test
}  // namespace abstand::safety
