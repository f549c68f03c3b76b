// Support functions and what they prove.
#include "core/query/separation.hpp"

#include <gtest/gtest.h>

#include "core/query/pair_query.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/support/structures.hpp"

namespace abstand::testing {
namespace separation_test {

constexpr double kSagitta = 5e-4;
/// m; float rounding of coordinates below a metre.
constexpr double kFloat = 1e-6;

Vector3d direction(std::uint64_t seed) { return randomPose(seed + 77).linear().col(0); }

double farthest(const geometry::TriangleMesh& mesh, const Vector3d& g) {
  double reach = -kInfinity;
  for (const Vector3d& p : mesh.vertices) reach = std::max(reach, g.dot(p));
  return reach;
}

class SupportMapTest : public ::testing::TestWithParam<geometry::Shape> {};

TEST_P(SupportMapTest, MeshSupportIsNeverTooSmall) {
  geometry::TriangleMesh mesh = geometry::tessellate(GetParam(), kSagitta);
  for (Vector3d& p : mesh.vertices) p += Vector3d(0.3, -0.2, 0.1);
  const auto surface = geometry::makeSurface(geometry::TriangleMesh(mesh));
  const structure::SupportMap map(*surface, mesh, surface->bounds().centre(), 2);
  double radius = 0.0;
  for (const Vector3d& p : mesh.vertices) radius = std::max(radius, (p - surface->bounds().centre()).norm());
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const Vector3d g =
        i < 6 ? Vector3d(Vector3d::Unit(static_cast<int>(i) / 2) * (i % 2 ? -1.0 : 1.0)) : direction(i);
    const double exact = farthest(mesh, g);
    ASSERT_GE(map.upper(g), exact);
    ASSERT_GE(map.closeUpper(g), exact);
    ASSERT_LE(map.closeUpper(g), exact + kFloat);
    // A cell is 1/16 wide, and the longest hull edge two radii long (support_map.hpp).
    ASSERT_LE(map.upper(g), exact + 2.0 * radius / 64.0);
    ASSERT_NEAR(g.dot(map.extreme(g).point), exact, kFloat);
  }
}

TEST_P(SupportMapTest, ShapeSupportMatchesPoints) {
  const auto surface = geometry::makeSurface(GetParam());
  const geometry::TriangleMesh mesh = geometry::tessellate(GetParam(), kSagitta);
  const structure::SupportMap map(*surface, mesh, Vector3d::Zero());
  for (std::uint64_t i = 0; i < 500; ++i) {
    const Vector3d g = direction(i);
    ASSERT_NEAR(map.upper(g), farthest(mesh, g), kSagitta);
    ASSERT_NEAR(map.upper(2.0 * g), 2.0 * map.upper(g), 1e-12);
    ASSERT_NEAR(g.dot(map.extreme(g).point), map.upper(g), 1e-12);
    ASSERT_LT(surface->closest(map.extreme(g).point).distance, 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, SupportMapTest,
                         ::testing::Values(geometry::Shape(geometry::Sphere{0.05}),
                                           geometry::Shape(geometry::Ellipsoid{{0.04, 0.05, 0.12}}),
                                           geometry::Shape(geometry::Cuboid{{0.1, 0.12, 0.3}}),
                                           geometry::Shape(geometry::Cylinder{0.05, 0.2}),
                                           geometry::Shape(geometry::Capsule{0.04, 0.15})));

TEST(Separation, BallsAlongCentresHaveTheirDistance) {
  const auto& ball = structureOf(geometry::Sphere{0.05}, structure::FieldKind::kMixed);
  for (std::uint64_t i = 0; i < 100; ++i) {
    const Transform X_WA = randomPose(i), X_WB = randomPose(i + 1000);
    const Vector3d way = X_WA.translation() - X_WB.translation();
    EXPECT_NEAR(query::separationAlong(way.normalized(), {ball, X_WA}, {ball, X_WB}, false), way.norm() - 0.1,
                1e-12);
    EXPECT_LE(query::separationAlong(direction(i), {ball, X_WA}, {ball, X_WB}, false),
              way.norm() - 0.1 + 1e-12);
  }
}

TEST(Separation, MotionBoundHoldsForEveryPoint) {
  const geometry::EnclosingSphere sphere{{0.1, -0.2, 0.05}, 0.3};
  for (std::uint64_t i = 0; i < 500; ++i) {
    const Transform X_0 = randomPose(i), X_1 = randomPose(i + 5000);
    const double most = query::maxDisplacement(sphere, X_0, X_1);
    for (std::uint64_t k = 0; k < 20; ++k) {
      const Vector3d p = sphere.centre + sphere.radius * direction(i + 31 * k);
      ASSERT_LE((X_1 * p - X_0 * p).norm(), most + 1e-12);
    }
  }
}

}  // namespace separation_test
}  // namespace abstand::testing
