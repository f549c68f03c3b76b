// Leaks, thin walls and hulls of bodies whose answer is known.
#include "core/store/build_report.hpp"

#include <gtest/gtest.h>

#include "core/geometry/convex_hull.hpp"
#include "tests/support/random_pose.hpp"

namespace abstand::store {
namespace build_report_test {

constexpr structure::HapticOptions kOptions{.voxel_size = 0.005, .point_spacing = 0.005, .outer_layers = 2};
// m; shell points are floats.
constexpr double kRounding = 1e-6;

BuildReport reportOf(std::shared_ptr<const geometry::Surface> surface,
                     const structure::HapticOptions& options = kOptions) {
  return reportOn(*structure::buildHapticStructure("body", std::move(surface), options, 1));
}

/// Extrudes a polygon (x, y), counter-clockwise and in ears (triples of its corners), to z from 0 to height.
geometry::TriangleMesh prism(const std::vector<Eigen::Vector2d>& polygon,
                             const std::vector<std::array<std::uint32_t, 3>>& ears, double height) {
  geometry::TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(polygon.size());
  for (const double z : {0.0, height})
    for (const auto& p : polygon) mesh.vertices.emplace_back(p.x(), p.y(), z);
  for (const auto& e : ears) {
    mesh.triangles.push_back({e[0], e[2], e[1]});
    mesh.triangles.push_back({e[0] + n, e[1] + n, e[2] + n});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    mesh.triangles.push_back({i, j, j + n});
    mesh.triangles.push_back({i, j + n, i + n});
  }
  return mesh;
}

/// A square of 0.1 m with a slot of 0.02 m, 0.06 m deep, from the middle of its upper side; 0.1 m high.
geometry::TriangleMesh fork() {
  return prism({{0, 0}, {.1, 0}, {.1, .1}, {.06, .1}, {.06, .04}, {.04, .04}, {.04, .1}, {0, .1}},
               {{0, 5, 6}, {0, 6, 7}, {0, 1, 5}, {1, 4, 5}, {1, 2, 4}, {2, 3, 4}}, 0.1);
}

/// A square of 0.1 m with a fin of 3 mm and 0.05 m length on top of it; 0.1 m high.
geometry::TriangleMesh fin() {
  return prism({{0, 0}, {.1, 0}, {.1, .1}, {.053, .1}, {.053, .15}, {.05, .15}, {.05, .1}, {0, .1}},
               {{0, 6, 7}, {0, 1, 6}, {1, 3, 6}, {1, 2, 3}, {3, 4, 5}, {3, 5, 6}}, 0.1);
}

TEST(BuildReport, ReportsSlotClosedByHull) {
  const std::shared_ptr<const geometry::Surface> surface = geometry::makeSurface(fork());
  ASSERT_TRUE(surface->watertight());
  const BuildReport r = reportOf(surface);
  EXPECT_EQ(r.open_edges + r.non_manifold_edges + r.flipped_edges, 0u);
  EXPECT_FALSE(r.inside_doubtful);
  EXPECT_EQ(r.thin_walls.share, 0.0);
  EXPECT_TRUE(std::isnan(r.thin_walls.thinnest));
  ASSERT_TRUE(r.hull);
  EXPECT_NEAR(r.hull->volume_ratio, 1.0 / (1.0 - 0.2 * 0.6), 1e-12);
  // The slot's bottom is 0.06 m from the hull's top, but 0.04 m from its other side, and in its middle 0.05 m
  // from front and back. Its walls, 0.04 m from the sides.
  EXPECT_NEAR(r.hull->worst, 0.04, kRounding);
  EXPECT_GE(r.hull->where.y(), 0.04 - kRounding);
}

TEST(BuildReport, ReportsFinThinnerThanVoxels) {
  const std::shared_ptr<const geometry::Surface> surface = geometry::makeSurface(fin());
  ASSERT_TRUE(surface->watertight());
  const BuildReport r = reportOf(surface);
  EXPECT_EQ(r.thin_walls.below, 0.01);
  EXPECT_NEAR(r.thin_walls.thinnest, 0.003, kRounding);
  EXPECT_GE(r.thin_walls.where.y(), 0.1 - kRounding);
  // Both sides of the fin over the whole area, within a point's share at its rim.
  const double sides = 2.0 * 0.05 * 0.1;
  EXPECT_NEAR(r.thin_walls.share, sides / surface->area(), 0.05 * sides / surface->area());
  // With voxels of 1 mm the fin is three voxels thick.
  EXPECT_EQ(
      reportOf(surface, {.voxel_size = 0.001, .point_spacing = 0.01, .outer_layers = 1}).thin_walls.share,
      0.0);
}

TEST(BuildReport, ReportsShapes) {
  const BuildReport ball = reportOf(geometry::makeSurface(geometry::Sphere{0.05}));
  EXPECT_EQ(ball.thin_walls.share, 0.0);
  ASSERT_TRUE(ball.hull);
  EXPECT_EQ(ball.hull->volume_ratio, 1.0);
  EXPECT_EQ(ball.hull->worst, 0.0);
  const BuildReport sheet = reportOf(geometry::makeSurface(geometry::Cuboid{{0.2, 0.1, 0.004}}));
  EXPECT_NEAR(sheet.thin_walls.thinnest, 0.004, kRounding);
  const double faces = 0.2 * 0.1, rim = 0.004 * 0.3;
  EXPECT_NEAR(sheet.thin_walls.share, faces / (faces + rim), 0.02);
}

TEST(BuildReport, ReportsOpenMesh) {
  geometry::TriangleMesh mesh = fork();
  mesh.triangles.pop_back();
  const BuildReport r = reportOf(geometry::makeSurface(mesh));
  EXPECT_EQ(r.open_edges, 3u);
  EXPECT_TRUE(r.inside_doubtful);
  // Two boxes that cut each other are closed, but what is inside is not certain.
  geometry::TriangleMesh two = geometry::tessellate(geometry::Cuboid{{0.1, 0.1, 0.1}}, 0.01);
  const auto n = static_cast<std::uint32_t>(two.vertices.size());
  const std::size_t triangles = two.triangles.size();
  for (std::uint32_t i = 0; i < n; ++i) two.vertices.push_back(two.vertices[i] + Vector3d(0.05, 0.03, 0.02));
  for (std::size_t t = 0; t < triangles; ++t) {
    const auto& a = two.triangles[t];
    two.triangles.push_back({a[0] + n, a[1] + n, a[2] + n});
  }
  const BuildReport cut = reportOf(geometry::makeSurface(two));
  EXPECT_EQ(cut.open_edges, 0u);
  EXPECT_TRUE(cut.inside_doubtful);
}

TEST(BuildReport, ReportsFlatMesh) {
  geometry::TriangleMesh sheet;
  sheet.vertices = {{0, 0, 0}, {0.1, 0, 0}, {0.1, 0.1, 0}, {0, 0.1, 0}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  const BuildReport r = reportOf(geometry::makeSurface(sheet));
  EXPECT_EQ(r.open_edges, 4u);
  EXPECT_TRUE(r.inside_doubtful);
  EXPECT_FALSE(r.hull);
}

TEST(ConvexHull, BoxMatchesClosedForm) {
  std::vector<Vector3d> points;
  for (int i = 0; i < 8; ++i) points.emplace_back(i & 1 ? 3 : 1, i & 2 ? 2 : 0, i & 4 ? 5 : 0);
  for (int i = 0; i < 100; ++i)
    points.push_back(Vector3d(2.0, 1.0, 2.5) + testing::randomPose(i, 0.99).translation());
  const auto hull = geometry::convexHull(points);
  ASSERT_TRUE(hull);
  EXPECT_NEAR(hull->volume, 2.0 * 2.0 * 5.0, 1e-12);
  EXPECT_NEAR(hull->depth({2.0, 1.0, 2.5}), 1.0, 1e-12);
  EXPECT_NEAR(hull->depth({1.25, 1.0, 2.5}), 0.25, 1e-12);
  EXPECT_NEAR(hull->depth({2.0, 1.0, 5.5}), -0.5, 1e-12);
}

// Every point is inside, and every plane is held by three of them.
TEST(ConvexHull, EnclosesRandomPoints) {
  std::vector<Vector3d> points;
  for (int i = 0; i < 500; ++i) points.push_back(testing::randomPose(i, 1.0).translation());
  const auto hull = geometry::convexHull(points);
  ASSERT_TRUE(hull);
  constexpr double kExact = 1e-12;
  for (const Vector3d& p : points) EXPECT_GE(hull->depth(p), -kExact);
  for (Eigen::Index f = 0; f < hull->planes.rows(); ++f) {
    int on = 0;
    for (const Vector3d& p : points) on += std::abs(hull->planes.row(f) * p.homogeneous()) < kExact ? 1 : 0;
    EXPECT_GE(on, 3);
    EXPECT_NEAR(hull->planes.row(f).head<3>().norm(), 1.0, kExact);
  }
}

TEST(ConvexHull, IsEmptyForFlatInput) {
  EXPECT_FALSE(geometry::convexHull({}));
  EXPECT_FALSE(geometry::convexHull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_FALSE(geometry::convexHull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.3, 0.2, 0}}));
  EXPECT_FALSE(geometry::convexHull(std::vector<Vector3d>(10, Vector3d(1, 2, 3))));
}

}  // namespace build_report_test
}  // namespace abstand::store
