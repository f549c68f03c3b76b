// What a wall pressed into a body should push with: closed forms against triangles, boxes against arithmetic.
#include "core/shell/half_space_overlap.hpp"

#include <gtest/gtest.h>

#include <random>

namespace abstand::shell {
namespace half_space_overlap_test {

TEST(HalfSpaceOverlap, EllipsoidCapMatchesMesh) {
  // Triangles within a sagitta s of the surface take away a shell of s at most: of a cap of the height h,
  // about s / h of its volume, 2 s / h with the rim.
  constexpr double kSagitta = 1e-5;
  const geometry::Shape shape = geometry::Ellipsoid{{0.05, 0.12, 0.3}};
  const auto surface = geometry::makeSurface(shape);
  const auto exact = halfSpaceOverlap(*surface, kSagitta);
  const MeshOverlap mesh(geometry::tessellate(shape, kSagitta));
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  for (int k = 0; k < 200; ++k) {
    const Vector3d u = Vector3d(normal(random), normal(random), normal(random)).normalized();
    EXPECT_NEAR(exact->lowest(u), mesh.lowest(u), kSagitta + 1e-6);
    const double depths[] = {0.004, 0.01, 0.03, 0.2, 2.0};
    double levels[5];
    for (int i = 0; i < 5; ++i) levels[i] = exact->lowest(u) + depths[i];
    Vector3d a[5], b[5];
    exact->forces(u, levels, a);
    mesh.forces(u, levels, b);
    for (int i = 0; i < 5; ++i) {
      const double most =
          i < 3 ? 2.0 * kSagitta / depths[i] * a[i].norm() : kSagitta * geometry::surfaceArea(shape);
      EXPECT_LT((a[i] - b[i]).norm(), most) << depths[i];
    }
    EXPECT_NEAR(a[4].norm(), geometry::massProperties(shape).volume, 1e-12) << "the whole body";
  }
}

TEST(HalfSpaceOverlap, BoxHasSlabVolumeAndSheetHasNone) {
  const auto box = geometry::makeSurface(geometry::Cuboid{{0.2, 0.4, 0.6}});
  const auto overlap = halfSpaceOverlap(*box, 1e-3);
  const double level = -0.3 + 0.05;
  Vector3d force;
  overlap->forces(Vector3d::UnitZ(), {&level, 1}, {&force, 1});
  EXPECT_LT((force - 0.2 * 0.4 * 0.05 * Vector3d::UnitZ()).norm(), 1e-15);

  geometry::TriangleMesh sheet;
  sheet.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 1}};
  const double above = 0.1;
  MeshOverlap(sheet).forces(Vector3d::UnitZ(), {&above, 1}, {&force, 1});
  EXPECT_TRUE(force.isZero(0.0));
}

}  // namespace half_space_overlap_test
}  // namespace abstand::shell
