// Directions of pairs, and what the joints have to do with a distance.
#include "core/control/pair_direction.hpp"

#include <gtest/gtest.h>

#include "core/math/random.hpp"
#include "core/robot_file/mech_file.hpp"
#include "tests/support/paths.hpp"

namespace abstand::control {
namespace pair_direction_test {

TEST(PartingDirection, KeepsSignUnderPenetration) {
  query::PairResult r;
  EXPECT_EQ(partingDirection(r, Vector3d::UnitX()), Vector3d::UnitX());
  r.distance = 0.1;
  r.witness_a = {0, 0, 0.1};
  r.witness_b = {0, 0, 0};
  EXPECT_EQ(partingDirection(r), Vector3d(0, 0, 1));
  // A's deepest point 1 cm below B's surface.
  r.distance = -0.01;
  r.witness_a = {0, 0, -0.01};
  EXPECT_EQ(partingDirection(r), Vector3d(0, 0, 1));
  // One point: the force tells.
  r.distance = 0.0;
  r.witness_a = r.witness_b;
  r.force_a = {0, 3, 0};
  EXPECT_EQ(partingDirection(r), Vector3d(0, 1, 0));
}

TEST(DistanceRow, MatchesRateOfDistance) {
  // A ball on the last frame of an arm and a ball in the room.
  const mechanism::Mechanism arm =
      robot_file::loadMechanism(testing::projectFile("data/robots/lwr/lwr4.mech"));
  mechanism::MechanismState state;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(13, seed);
    std::vector<double> q(7), qd(7), row(7, 0.0);
    for (auto& x : q) x = random.between(-2, 2);
    for (auto& x : qd) x = random.between(-1, 1);
    const Vector3d other = random.inCube(1.5);
    const int frame = static_cast<int>(random.below(7));
    const Vector3d p_F(0.1, 0.0, 0.05);
    const auto distance = [&](double t) {
      std::vector<double> at(7);
      for (int i = 0; i < 7; ++i) at[i] = q[i] + t * qd[i];
      mechanism::forward(arm, at, state);
      return (state.X_BF[frame] * p_F - other).norm();
    };
    constexpr double kStep = 1e-6;
    const double rate = (distance(kStep) - distance(-kStep)) / (2 * kStep);
    distance(0.0);
    const Vector3d p_B = state.X_BF[frame] * p_F;
    addDistanceRow(arm, state, {frame, p_B, (p_B - other).normalized()}, 1.0, row);
    double found = 0.0;
    for (int i = 0; i < 7; ++i) found += row[i] * qd[i];
    EXPECT_NEAR(found, rate, 1e-7);
    // Twice with both signs is nothing; the base has no row.
    addDistanceRow(arm, state, {frame, p_B, (p_B - other).normalized()}, -1.0, row);
    addDistanceRow(arm, state, {-1, p_B, Vector3d::UnitX()}, 1.0, row);
    for (const double x : row) EXPECT_NEAR(x, 0.0, 1e-15);
  }
}

TEST(FastestAlong, BoundsEveryPointOfBody) {
  double fullest = 0.0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    Random random(14, seed);
    const Twist twist{random.inCube(1.0), random.inCube(2.0)};
    const Vector3d p = random.inCube(0.3), n = random.direction();
    const geometry::EnclosingSphere sphere{random.inCube(0.3), random.between(0.01, 0.4)};
    const double most = fastestAlong(n, twist, p, sphere);
    for (int k = 0; k < 50; ++k) {
      const Vector3d u = sphere.centre + sphere.radius * random.direction();
      const double speed = n.dot(twist.linear + twist.angular.cross(Vector3d(u - p)));
      ASSERT_LE(speed, most + 1e-12) << seed;
      fullest = std::max(fullest, speed - most);
    }
  }
  EXPECT_GT(fullest, -0.01);
}

}  // namespace pair_direction_test
}  // namespace abstand::control
