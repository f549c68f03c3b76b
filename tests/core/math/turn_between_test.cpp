#include "core/math/turn_between.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math/random.hpp"

namespace abstand {
namespace turn_between_test {

constexpr double kRounding = 1e-12;

TEST(TurnBetween, RotatesByAngleBetweenDirections) {
  for (std::uint64_t k = 0; k < 1000; ++k) {
    Random random(7, k);
    const Vector3d from = random.direction(), to = random.direction();
    const Quaterniond q = turnBetween(3.0 * from, 0.01 * to);
    EXPECT_LT((q * from - to).norm(), kRounding);
    const double angle = std::atan2(from.cross(to).norm(), from.dot(to));
    EXPECT_NEAR(2.0 * std::atan2(q.vec().norm(), std::abs(q.w())), angle, kRounding);
  }
}

TEST(TurnBetween, RotatesOppositesByHalfTurn) {
  // Nearly opposite is taken for opposite within the rounding of a cosine: its root, in radians.
  const double kRoot = 1e-6;
  for (std::uint64_t k = 0; k < 100; ++k) {
    const Vector3d from = Random(8, k).direction();
    const Quaterniond q = turnBetween(from, -from);
    EXPECT_LT((q * from + from).norm(), kRoot);
    EXPECT_NEAR(q.norm(), 1.0, kRounding);
    EXPECT_EQ(turnBetween(from, -from).coeffs(), q.coeffs());
  }
}

}  // namespace turn_between_test
}  // namespace abstand
