// Welding, and mass properties of meshes.
#include "core/geometry/triangle_mesh.hpp"

#include <gtest/gtest.h>

#include "core/geometry/shape.hpp"
#include "tests/support/brute_force.hpp"

namespace abstand::geometry {
namespace triangle_mesh_test {

using testing::randomPose;
using testing::randomUnit;

/// Every triangle with three vertices of its own, each moved by less than `jitter`.
TriangleMesh soup(const TriangleMesh& mesh, double jitter) {
  TriangleMesh out;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i)
      out.vertices.push_back(mesh.corner(t, i) +
                             testing::randomPoint(3 * t + static_cast<std::size_t>(i), jitter));
    const auto first = static_cast<std::uint32_t>(3 * t);
    out.triangles.push_back({first, first + 1, first + 2});
  }
  return out;
}

TEST(Weld, JoinsCornersOfTriangleSoup) {
  const auto ball = tessellate(Sphere{1.0}, 0.01);
  const double jitter = 1e-7;
  const auto welded = weld(soup(ball, jitter), 2 * std::sqrt(3.0) * jitter);
  EXPECT_EQ(welded.vertices.size(), ball.vertices.size());
  EXPECT_EQ(welded.triangles.size(), ball.triangles.size());
  EXPECT_NEAR(massProperties(welded).volume, massProperties(ball).volume, 1e-6);
  // Exact copies need no tolerance; without one, the moved ones stay apart.
  EXPECT_EQ(weld(soup(ball, 0.0), 0.0).vertices.size(), ball.vertices.size());
  EXPECT_EQ(weld(soup(ball, jitter), 0.0).vertices.size(), 3 * ball.triangles.size());
}

TEST(Weld, KeptVerticesAreFartherApartThanTolerance) {
  TriangleMesh mesh;
  for (std::uint64_t i = 0; i < 3000; ++i) mesh.vertices.push_back(testing::randomPoint(i, 1.0));
  for (std::uint32_t i = 0; i < 3000; i += 3) mesh.triangles.push_back({i, i + 1, i + 2});
  const double tolerance = 0.1;
  const auto welded = weld(mesh, tolerance);
  for (std::size_t i = 0; i < welded.vertices.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      ASSERT_GT((welded.vertices[i] - welded.vertices[j]).norm(), tolerance);
  EXPECT_LT(welded.vertices.size(), 2900u);
}

TEST(Weld, DropsCollapsedTrianglesAndUnusedVertices) {
  TriangleMesh mesh;
  mesh.vertices = {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1e-9, 0}, {-0.0, 0, 0}};
  mesh.triangles = {{1, 2, 3}, {1, 2, 4}, {2, 2, 3}, {5, 2, 3}};
  const auto welded = weld(mesh, 1e-6);
  EXPECT_EQ(welded.vertices.size(), 3u);
  ASSERT_EQ(welded.triangles.size(), 2u);
  EXPECT_EQ(welded.triangles[0], welded.triangles[1]);
  EXPECT_TRUE(weld(TriangleMesh{}, 1.0).triangles.empty());
}

TEST(MeshMass, MatchesCuboidAtAnyPose) {
  // Rounding grows with the distance from the origin: 10 m times 2^-52, over sizes of 0.1 m.
  constexpr double kTolerance = 1e-13;
  const Cuboid box{{0.2, 0.3, 0.5}};
  const auto exact = massProperties(Shape{box});
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Transform X_WB = randomPose(seed, 10.0);
    auto mesh = tessellate(box, 1.0);
    for (auto& v : mesh.vertices) v = X_WB * v;
    const auto m = massProperties(mesh);
    EXPECT_NEAR(m.volume, exact.volume, kTolerance);
    EXPECT_NEAR(signedVolume(mesh), exact.volume, kTolerance);
    EXPECT_LE((m.com - X_WB.translation()).norm(), kTolerance * 100);
    EXPECT_LE((m.inertia - X_WB.linear() * exact.inertia * X_WB.linear().transpose()).norm(), kTolerance);
  }
}

TEST(MeshMass, OpenMeshHasAreaCentroid) {
  TriangleMesh sheet;  // a unit square in the plane z = 1
  sheet.vertices = {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  const auto m = massProperties(sheet);
  EXPECT_EQ(m.volume, 0.0);
  EXPECT_TRUE(m.inertia.isZero(0.0));
  EXPECT_LE((m.com - Vector3d(0.5, 0.5, 1)).norm(), 1e-15);

  auto inside_out = tessellate(Cuboid{{1, 1, 1}}, 1.0);
  for (auto& t : inside_out.triangles) std::swap(t[0], t[1]);
  EXPECT_NEAR(signedVolume(inside_out), -1.0, 1e-15);
  EXPECT_EQ(massProperties(inside_out).volume, 0.0);
  EXPECT_LE(massProperties(inside_out).com.norm(), 1e-15);

  EXPECT_EQ(massProperties(TriangleMesh{}).volume, 0.0);
  EXPECT_EQ(surfaceArea(sheet), 1.0);
}

}  // namespace triangle_mesh_test
}  // namespace abstand::geometry
