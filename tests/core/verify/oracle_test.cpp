// The judge is judged: brute-force distances and depths against sampling and known answers.
#include <gtest/gtest.h>

#include "core/math/random.hpp"
#include "core/verify/meshes.hpp"
#include "core/verify/penetration.hpp"

namespace abstand::verify {
namespace oracle_test {

constexpr double kExact = 1e-12;  // of lengths of about 1: rounding in double

Triangle randomTriangle(Random& random, double thin) {
  Triangle t;
  for (Vector3d& corner : t) corner = random.inCube(1.0).cwiseProduct(Vector3d(1.0, thin, 1.0));
  return t;
}

/// Points of a triangle, no point of it farther than `spacing` from one of them.
std::vector<Vector3d> sample(const Triangle& t, int steps, double& spacing) {
  std::vector<Vector3d> points;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; i + j <= steps; ++j)
      points.push_back(t[0] + (t[1] - t[0]) * i / steps + (t[2] - t[0]) * j / steps);
  spacing = std::max((t[1] - t[0]).norm(), (t[2] - t[0]).norm()) / steps;
  return points;
}

TEST(BruteForce, TriangleDistanceMatchesSampling) {
  int cutting = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(7, seed);
    const double thin = seed % 3 == 0 ? 1e-4 : 1.0;
    const Triangle s = randomTriangle(random, thin);
    Triangle t = randomTriangle(random, 1.0);
    if (seed % 2) {
      const Vector3d away = random.direction();
      for (Vector3d& corner : t) corner += away;
    }
    double s_spacing = 0.0, t_spacing = 0.0;
    const auto s_points = sample(s, 24, s_spacing), t_points = sample(t, 24, t_spacing);
    double least = kInfinity;
    for (const Vector3d& p : s_points)
      for (const Vector3d& q : t_points) least = std::min(least, (p - q).norm());
    const double distance = distanceTriangles(s, t);
    EXPECT_LE(distance, least + kExact);
    EXPECT_GE(distance, least - s_spacing - t_spacing);
    EXPECT_NEAR(distance, distanceTriangles(t, s), kExact);
    cutting += distance == 0.0;
  }
  EXPECT_GT(cutting, 10);
}

// Of edges in the other triangle's plane rounding says that they cross it, and where.
TEST(BruteForce, CoplanarTrianglesApartDoNotIntersect) {
  constexpr double kGap = 0.002, kRounding = 1e-14;
  for (std::uint64_t seed = 0; seed < 20000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(9, seed);
    const Matrix3d R = random.rotation();
    const Vector3d away = random.inCube(3.0);
    Triangle s, t;
    for (Vector3d& corner : s) corner = away + R * Vector3d(-random.unit(), random.between(-2.0, 2.0), 0.0);
    for (Vector3d& corner : t) corner = away + R * Vector3d(kGap + 0.1 * random.unit(), random.unit(), 0.0);
    ASSERT_GE(distanceTriangles(s, t), kGap - kRounding);
  }
}

TEST(BruteForce, PointTriangleDistanceMatchesSampling) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    Random random(8, seed);
    const Triangle t = randomTriangle(random, seed % 3 == 0 ? 1e-4 : 1.0);
    const Vector3d p = random.inCube(2.0);
    double spacing = 0.0, least = kInfinity;
    for (const Vector3d& q : sample(t, 60, spacing)) least = std::min(least, (p - q).norm());
    const double distance = distancePointTriangle(p, t);
    EXPECT_LE(distance, least + kExact);
    EXPECT_GE(distance, least - spacing);
    // A point over the middle of the triangle is as far as it is lifted.
    const Vector3d n = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    EXPECT_NEAR(distancePointTriangle((t[0] + t[1] + t[2]) / 3.0 + 0.3 * n, t), 0.3, 1e-9);
  }
}

TEST(BruteForce, SegmentDistanceHandlesParallelAndDegenerate) {
  const Vector3d o(0, 0, 0), x(1, 0, 0), y(0, 1, 0);
  EXPECT_NEAR(distanceSegments(o - x, x, Vector3d(0, -1, 0.25), Vector3d(0, 1, 0.25)), 0.25, kExact);
  EXPECT_NEAR(distanceSegments(o, x, y, x + y), 1.0, kExact);          // parallel, beside each other
  EXPECT_NEAR(distanceSegments(o, x, 3 * x, 4 * x), 2.0, kExact);      // in one line
  EXPECT_NEAR(distanceSegments(o, o, y, y), 1.0, kExact);              // points
  EXPECT_NEAR(distanceSegments(o, x, x + y, 2 * x + y), 1.0, kExact);  // end over end
  EXPECT_NEAR(distanceSegments(o, x, Vector3d(2, 1, 0), Vector3d(2, -1, 0)), 1.0, kExact);
}

TEST(BruteForce, WindingNumberSeparatesInsideFromOutside) {
  const TriangleSoup star(starMesh(0.3, 0.8));
  const TriangleSoup ring(torusMesh(0.6, 0.15, 12, 8));
  EXPECT_TRUE(star.inside(Vector3d(0.1, 0.05, 0.0)));
  EXPECT_FALSE(star.inside(Vector3d(0.7, 0.7, 0.0)));
  EXPECT_FALSE(ring.inside(Vector3d::Zero()));
  EXPECT_TRUE(ring.inside(Vector3d(0.6, 0.0, 0.0)));
  EXPECT_NEAR(star.windingNumber(Vector3d(0.01, 0.02, 0.03)), 1.0, kExact);
  EXPECT_NEAR(ring.windingNumber(Vector3d(0.0, 0.0, 2.0)), 0.0, kExact);
}

TEST(BruteForce, MeshesHavePiecesAndDistances) {
  const TriangleSoup two(together(boxMesh({1, 1, 1}), boxMesh({1, 1, 1}, {3, 0, 0})));
  EXPECT_EQ(two.probes().size(), 2u);
  const TriangleSoup box(boxMesh({0.5, 0.5, 0.5}, {1.5, 0, 0}));
  EXPECT_NEAR(two.distanceTo(box), 0.75, kExact);
  EXPECT_EQ(two.distanceTo(TriangleSoup(boxMesh({1, 1, 1}, {0.5, 0.5, 0.5}))), 0.0);
  // Every triangle of a closed mesh has a neighbour at distance 0.
  EXPECT_EQ(two.distanceTo(two), 0.0);
}

TEST(Penetration, BoxInBoxMatchesDepth) {
  const TriangleSoup wall(boxMesh({4, 4, 2}));
  Transform X = Transform::Identity();
  for (const double depth : {0.05, 0.3}) {
    SCOPED_TRACE(depth);
    X.translation() = Vector3d(0.2, 0.1, 1.0 + 0.25 - depth);
    const Penetration p = penetration(TriangleSoup(boxMesh({0.5, 0.5, 0.5})).moved(X), wall, 0.02, 100'000);
    EXPECT_LE(p.lower, depth + kExact);
    EXPECT_GE(p.upper, depth - kExact);
    EXPECT_LE(p.upper - p.lower, 0.02);
  }
}

TEST(Penetration, CornerDepthIsEnclosed) {
  // A cube on its corner: the tip alone is deep.
  const TriangleSoup wall(boxMesh({4, 4, 2}));
  Transform X = fromXyzRpy({0.1, 0.2, 0}, {kPi / 4, std::atan(std::sqrt(0.5)), 0.3});
  X.translation().z() = 1.0 + 0.5 * std::sqrt(3.0) - 0.2;
  const Penetration p = penetration(TriangleSoup(boxMesh({1, 1, 1})).moved(X), wall, 0.001, 5000);
  EXPECT_LE(p.lower, 0.2 + kExact);
  EXPECT_GE(p.upper, 0.2 - kExact);
  EXPECT_LE(p.upper - p.lower, 0.001);
}

TEST(Penetration, IsNegativeWithoutOverlap) {
  const TriangleSoup a(boxMesh({1, 1, 1})), b(boxMesh({1, 1, 1}, {3, 0, 0}));
  EXPECT_LT(penetration(a, b, 0.01, 1000).upper, 0.0);
}

}  // namespace oracle_test
}  // namespace abstand::verify
