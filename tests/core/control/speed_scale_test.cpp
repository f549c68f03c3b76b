// Speed by distance and direction.
#include "core/control/speed_scale.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "core/base/error.hpp"
#include "core/math/random.hpp"
#include "tests/support/no_alloc.hpp"

namespace abstand::control {
namespace speed_scale_test {

constexpr double kExact = 1e-9;
constexpr double kDt = 1e-3;

SpeedScaleOptions example() {
  SpeedScaleOptions o;
  o.separation.intrusion = 0.2;
  o.separation.person_error = 0.1;
  o.separation.robot_error = 0.05;
  return o;
}

double scaleOf(std::vector<Approach> pairs, const SpeedScaleOptions& o = example()) {
  SpeedScale law(o);
  return law.update(pairs, kDt);
}

TEST(SpeedScale, IsPermittedShare) {
  // S_p = 0.99 + 0.25 v_r: at 1.115 m half a metre a second is permitted.
  EXPECT_NEAR(scaleOf({{1.115, 1.0, kNaN}}), 0.5, kExact);
  EXPECT_NEAR(scaleOf({{1.115, 2.0, kNaN}}), 0.25, kExact);
  EXPECT_NEAR(scaleOf({{1.24, 1.0, kNaN}}), 1.0, kExact);
  EXPECT_EQ(scaleOf({{1.241, 1.0, kNaN}}), 1.0);
  EXPECT_EQ(scaleOf({{0.9, 1.0, kNaN}}), 0.0);
  EXPECT_EQ(scaleOf({}), 1.0);
}

TEST(SpeedScale, DoesNotSlowRecedingRobot) {
  EXPECT_EQ(scaleOf({{0.01, -0.5, kNaN}}), 1.0) << "however near";
  EXPECT_EQ(scaleOf({{0.01, 0.0, kNaN}}), 1.0);
  // As near, coming nearer ever so slowly, it stops.
  EXPECT_EQ(scaleOf({{0.01, 1e-6, kNaN}}), 0.0);
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    Random random(8, seed);
    std::vector<Approach> pairs;
    for (int i = 0; i < 20; ++i)
      pairs.push_back({random.between(-0.1, 2.0), -random.unit(), random.between(-2.0, 2.0)});
    ASSERT_EQ(scaleOf(pairs), 1.0);
  }
}

TEST(SpeedScale, WorstPairDecidesAndIsReported) {
  SpeedScale law(example());
  const std::vector<Approach> pairs{
      {1.2, 1.0, kNaN}, {0.3, -1.0, kNaN}, {1.115, 1.0, kNaN}, {1.9, 2.0, kNaN}};
  EXPECT_NEAR(law.update(pairs, kDt), 0.5, kExact);
  EXPECT_EQ(law.slowest(), 2);
  EXPECT_NEAR(law.permitted(), 0.5, kExact);
  EXPECT_EQ(law.planned(), 1.0);
}

TEST(SpeedScale, EveryPairKeepsDistanceAtScale) {
  SpeedScaleOptions o = example();
  o.separation.person_acceleration = 5.0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    Random random(9, seed);
    o.separation.deceleration = seed % 2 ? 3.0 : 0.0;
    std::vector<Approach> pairs;
    for (int i = 0; i < 8; ++i)
      pairs.push_back({random.between(0.3, 3.0), random.between(-1.0, 2.0),
                       random.chance(0.3) ? kNaN : random.between(-2.0, 2.0)});
    const double s = scaleOf(pairs, o);
    for (const Approach& p : pairs) {
      if (p.robot > 0.0 && s > 0.0) {
        ASSERT_LE(safety::protectiveDistance(o.separation, s * p.robot, p.person, p.distance).sum(),
                  p.distance + kExact)
            << seed;
      }
    }
  }
}

TEST(SpeedScale, FallsAtOnceAndRisesSlowly) {
  SpeedScaleOptions o = example();
  o.release = 2.0;
  SpeedScale law(o);
  const std::vector<Approach> near{{0.5, 1.0, kNaN}}, far{{5.0, 1.0, kNaN}};
  EXPECT_EQ(law.update(near, kDt), 0.0);
  for (int i = 1; i <= 100; ++i) EXPECT_NEAR(law.update(far, kDt), 2e-3 * i, kExact);
  EXPECT_EQ(law.update(near, kDt), 0.0);
  law.update(far, 10.0);
  EXPECT_EQ(law.scale(), 1.0);
}

TEST(SpeedScale, UnknownValuesStop) {
  EXPECT_EQ(scaleOf({{kNaN, 1.0, kNaN}}), 0.0);
  EXPECT_EQ(scaleOf({{5.0, kNaN, kNaN}}), 0.0);
}

TEST(SpeedScale, AllocatesNothingAndRejectsBadOptions) {
  SpeedScale law(example());
  const std::vector<Approach> pairs(100, Approach{1.1, 1.0, 0.5});
  const testing::NoAlloc guard;
  for (int i = 0; i < 100; ++i) law.update(pairs, kDt);
  EXPECT_EQ(guard.count(), 0);
  SpeedScaleOptions o;
  o.release = 0.0;
  EXPECT_THROW(SpeedScale{o}, UsageError);
  o = {};
  o.separation.stopping_time = kNaN;
  EXPECT_THROW(SpeedScale{o}, UsageError);
}

/// A robot on a line goes to and fro before a person who comes as fast as is assumed: when they meet, the
/// robot stands. The person starts anywhere; the robot brakes within T_s after T_r.
TEST(SpeedScale, RobotStandsBeforePersonArrives) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(10, seed);
    SpeedScaleOptions o;
    o.separation.person_speed_near = o.separation.person_speed;
    const int delay = 100;  // T_r in steps: the robot hears of a scale so much later
    SpeedScale law(o);
    std::vector<double> heard(static_cast<std::size_t>(delay), 1.0);
    double robot = 0.0, person = random.between(1.3, 4.0), v = 1.0, planned = 1.0;
    const double deceleration = 1.0 / o.separation.stopping_time;
    bool comes = false;
    for (int i = 0; i < 20000; ++i) {
      planned = 1.0;
      comes |= random.chance(0.001);
      const std::vector<Approach> pairs{{person - robot, planned, kNaN}};
      const double scale = law.update(pairs, kDt);
      const double now = heard[static_cast<std::size_t>(i % delay)] * planned;
      heard[static_cast<std::size_t>(i % delay)] = scale;
      v = now < v ? std::max(now, v - deceleration * kDt) : now;
      robot += v * kDt;
      if (comes) person -= o.separation.person_speed * kDt;
      // A step of both is as fine as the loop sees.
      if (person - robot <= 2.6e-3) break;
    }
    ASSERT_TRUE(comes);
    // What the brakes take in the few steps by which the loop and the meeting are coarse.
    ASSERT_LE(v, 3.0 * deceleration * kDt);
  }
}

}  // namespace speed_scale_test
}  // namespace abstand::control
