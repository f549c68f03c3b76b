// Nearest points of two triangles, against distances found in another way.
#include "core/geometry/triangle_pair.hpp"

#include <gtest/gtest.h>

#include "core/verify/brute_force.hpp"
#include "tests/support/random_pose.hpp"

namespace abstand::testing {
namespace triangle_pair_test {

/// m; of coordinates below some metres.
constexpr double kRounding = 1e-9;

Vector3d somewhere(std::uint64_t seed, double reach) { return randomPose(seed, reach).translation(); }

/// Triangles of all sizes and proportions, apart and across each other.
geometry::TriangleCorners someTriangle(std::uint64_t seed) {
  const Vector3d centre = somewhere(3 * seed, 0.4);
  const double size = std::pow(10.0, -3.0 * randomUnit(seed, 5));
  const Vector3d u = size * somewhere(3 * seed + 1, 1.0);
  Vector3d v = size * somewhere(3 * seed + 2, 1.0);
  if (seed % 4 == 0) v = 2.0 * u + 1e-3 * v;  // a sliver
  return {centre, centre + u, centre + v};
}

bool isOn(const Vector3d& p, const geometry::TriangleCorners& t) {
  return verify::distancePointTriangle(p, t) < kRounding;
}

TEST(TrianglePair, MatchesBruteForceOverFeatures) {
  int cutting = 0;
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    const geometry::TriangleCorners a = someTriangle(2 * i), b = someTriangle(2 * i + 1);
    const double exact = verify::distanceTriangles(a, b);
    const geometry::NearestPair found = geometry::nearestPoints(a, b);
    ASSERT_NEAR((found.on_a - found.on_b).norm(), found.distance, kRounding);
    ASSERT_TRUE(isOn(found.on_a, a)) << i;
    ASSERT_TRUE(isOn(found.on_b, b)) << i;
    if (exact == 0.0) {
      ++cutting;
      continue;
    }
    ASSERT_NEAR(found.distance, exact, kRounding) << i;
  }
  EXPECT_GT(cutting, 20);
}

TEST(TrianglePair, ParallelTrianglesHavePlaneDistance) {
  const geometry::TriangleCorners a{Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 1, 0)};
  for (const double x : {-0.3, 0.0, 0.2, 0.9}) {
    geometry::TriangleCorners b = a;
    for (Vector3d& corner : b) corner += Vector3d(x, 0.1, 0.25);
    EXPECT_NEAR(geometry::nearestPoints(a, b).distance, 0.25, 1e-15) << x;
  }
}

}  // namespace triangle_pair_test
}  // namespace abstand::testing
