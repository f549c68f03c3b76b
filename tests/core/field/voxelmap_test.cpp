// Voxelmaps: the grid, surface voxels, insides and layers.
#include "core/field/voxelmap.hpp"

#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "core/field/voxelmap_sides.hpp"
#include "core/mesh_file/mesh_file.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/paths.hpp"

namespace abstand::field {
namespace voxelmap_test {

using testing::randomPoint;

template <class Fn>
void forVoxels(const VoxelGrid& grid, Fn&& fn) {
  for (int k = 0; k < grid.size.z(); ++k) {
    for (int j = 0; j < grid.size.y(); ++j) {
      for (int i = 0; i < grid.size.x(); ++i) fn(Vector3i(i, j, k), grid.index(i, j, k));
    }
  }
}

// All thirteen axes, one voxel and triangle at a time. `gap`: how far apart still counts as touching, in
// parts of the axis' length.
bool overlapsSlowly(const Vector3d& a, const Vector3d& b, const Vector3d& c, double half, double gap) {
  const Vector3d e[3] = {b - a, c - b, a - c};
  std::vector<Vector3d> axes{e[0].cross(e[1])};
  for (int i = 0; i < 3; ++i) {
    axes.push_back(Vector3d::Unit(i));
    for (const Vector3d& edge : e) axes.push_back(Vector3d::Unit(i).cross(edge));
  }
  for (const Vector3d& axis : axes) {
    const auto [least, most] = std::minmax({axis.dot(a), axis.dot(b), axis.dot(c)});
    const double reach = half * axis.cwiseAbs().sum() + gap * axis.norm();
    if (least > reach || most < -reach) return false;
  }
  return true;
}

geometry::TriangleMesh hollowBall() {
  geometry::TriangleMesh hollow = geometry::tessellate(geometry::Sphere{0.1}, 1e-3);
  const geometry::TriangleMesh hole = geometry::tessellate(geometry::Sphere{0.05}, 1e-3);
  const auto offset = static_cast<std::uint32_t>(hollow.vertices.size());
  hollow.vertices.insert(hollow.vertices.end(), hole.vertices.begin(), hole.vertices.end());
  for (const auto& t : hole.triangles)
    hollow.triangles.push_back({t[0] + offset, t[2] + offset, t[1] + offset});
  return hollow;
}

TEST(VoxelGrid, MatchesThesisGrid) {
  const VoxelGrid grid = makeGrid(geometry::bounds(geometry::Shape(geometry::Sphere{0.05})), 0.005, 20);
  EXPECT_EQ(grid.size, Vector3i(61, 61, 61));
  EXPECT_LT(grid.centre(30, 30, 30).norm(), 1e-15);
  // An extent of 0.7 is not quite 7 times 0.1.
  EXPECT_EQ(makeGrid(geometry::bounds(geometry::Shape(geometry::Cuboid{{0.7, 0.75, 0.1}})), 0.1, 0).size,
            Vector3i(8, 8, 2));
  EXPECT_THROW(makeGrid(geometry::bounds(geometry::Shape(geometry::Sphere{1000.0})), 1e-5, 0), UsageError);
  EXPECT_THROW(makeGrid(geometry::bounds(geometry::Shape(geometry::Sphere{0.05})), 0.005, 10'000),
               UsageError);
}

TEST(SurfaceVoxels, TrianglesMatchSeparatingAxisTest) {
  // Triangles of any shape, slivers and triangles in the planes between voxels among them.
  constexpr double kSize = 0.1;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    geometry::TriangleMesh mesh{
        {randomPoint(seed, 0.5), randomPoint(seed + 1000, 0.5), randomPoint(seed + 2000, 0.5)}, {{0, 1, 2}}};
    auto& v = mesh.vertices;
    if (seed % 3 == 1) v[2] = 0.3 * v[0] + 0.7 * v[1] + 1e-7 * v[2];
    if (seed % 3 == 2) v[0].z() = v[1].z() = v[2].z() = -0.05 + 0.1 * double(seed % 5);
    VoxelGrid grid{Vector3d::Constant(-0.55), kSize, Vector3i::Constant(12)};
    std::vector<std::int8_t> side(grid.cells(), kVoxelOutside);
    markTriangles(mesh, grid, 1, side);
    forVoxels(grid, [&](const Vector3i& p, std::size_t at) {
      const Vector3d c = grid.centre(p.x(), p.y(), p.z());
      const auto overlaps = [&](double gap) {
        return overlapsSlowly(v[0] - c, v[1] - c, v[2] - c, 0.5 * kSize, gap);
      };
      // A hundred times the tolerance either way; between the two, rounding decides.
      if (side[at] == kVoxelSurface) {
        EXPECT_TRUE(overlaps(1e-7 * kSize)) << seed << ": " << p.transpose();
      } else {
        EXPECT_FALSE(overlaps(-1e-7 * kSize)) << seed << ": " << p.transpose();
      }
    });
  }
}

// Signed distances from a point to the nearest and to the farthest point of the voxel about c.
Vector3d nearestOfVoxel(const Vector3d& c, double half, const Vector3d& p) {
  return p.cwiseMax((c.array() - half).matrix()).cwiseMin((c.array() + half).matrix());
}

TEST(SurfaceVoxels, SphereIsExact) {
  constexpr double kRadius = 0.0503, kVoxel = 0.005;
  const VoxelSides sides = findVoxelSides(*geometry::makeSurface(geometry::Sphere{kRadius}), kVoxel, 1);
  forVoxels(sides.grid, [&](const Vector3i& p, std::size_t at) {
    const Vector3d c = sides.grid.centre(p.x(), p.y(), p.z());
    const double nearest = nearestOfVoxel(c, 0.5 * kVoxel, Vector3d::Zero()).norm();
    const double farthest = (c.cwiseAbs().array() + 0.5 * kVoxel).matrix().norm();
    const int expected = farthest < kRadius  ? kVoxelInside
                         : nearest > kRadius ? kVoxelOutside
                                             : kVoxelSurface;
    ASSERT_EQ(int(sides.side[at]), expected) << p.transpose();
  });
}

TEST(SurfaceVoxels, ShapesMatchTheirMeshes) {
  for (const geometry::Shape& shape : testing::someShapes()) {
    // No whole number of voxels: a mesh is a little smaller than its shape and might get one less.
    const double voxel = geometry::bounds(shape).extent().maxCoeff() / 30.3;
    const double sagitta = 1e-3 * voxel;
    const VoxelSides exact = findVoxelSides(*geometry::makeSurface(shape), voxel, 2);
    const VoxelSides meshed =
        findVoxelSides(*geometry::makeSurface(geometry::tessellate(shape, sagitta)), voxel, 2);
    ASSERT_EQ(exact.grid.size, meshed.grid.size);
    // Only voxels that the surface just grazes may differ.
    std::size_t different = 0;
    for (std::size_t i = 0; i < exact.side.size(); ++i) different += exact.side[i] != meshed.side[i];
    EXPECT_LE(different, exact.surface_voxels / 50 + 2) << geometry::shapeName(shape);
    // A voxel at the surface counts for half.
    const double volume =
        (0.5 * double(exact.surface_voxels) + double(exact.solid_voxels - exact.surface_voxels)) * voxel *
        voxel * voxel;
    EXPECT_LT(std::abs(volume - geometry::massProperties(shape).volume),
              0.5 * double(exact.surface_voxels) * voxel * voxel * voxel)
        << geometry::shapeName(shape);
  }
}

TEST(Voxelmap, LayersCountStepsToSurface) {
  const Voxelmap map(*geometry::makeSurface(geometry::Ellipsoid{{0.04, 0.02, 0.03}}), 0.004, 5, 1);
  std::vector<Vector3i> surface;
  forVoxels(map.grid, [&](const Vector3i& p, std::size_t) {
    if (map.at(p) == 0) surface.push_back(p);
  });
  EXPECT_EQ(surface.size(), map.surface_voxels);
  std::size_t solid = 0;
  forVoxels(map.grid, [&](const Vector3i& p, std::size_t) {
    int steps = 1000;
    for (const Vector3i& s : surface) steps = std::min(steps, (s - p).cwiseAbs().maxCoeff());
    ASSERT_EQ(std::abs(map.at(p)), steps);
    solid += map.at(p) >= 0;
  });
  EXPECT_EQ(solid, map.solid_voxels);
}

TEST(Voxelmap, LayersMatchDistancesWithinVoxel) {
  // In front of and behind the faces of a cuboid the steps run straight along the normal.
  constexpr double kVoxel = 0.01;
  const geometry::Shape cuboid = geometry::Cuboid{{0.2, 0.3, 0.4}};
  for (const bool meshed : {false, true}) {
    const auto surface =
        meshed ? geometry::makeSurface(geometry::tessellate(cuboid, 0.01)) : geometry::makeSurface(cuboid);
    const Voxelmap map(*surface, kVoxel, 12, 2);
    EXPECT_FALSE(map.inside_doubtful);
    const Vector3i middle = (map.grid.size.array() - 1) / 2;
    for (int axis = 0; axis < 3; ++axis) {
      for (int i = 0; i < map.grid.size[axis]; ++i) {
        Vector3i p = middle;
        p[axis] = i;
        const double d = geometry::distanceTo(cuboid, map.grid.centre(p.x(), p.y(), p.z())).distance;
        EXPECT_NEAR(-kVoxel * map.at(p), d, kVoxel * 1.001);
      }
    }
  }
}

TEST(Voxelmap, LayersBoundDistances) {
  // Layer -k leaves k - 1 whole voxels to the surface voxels; the way there is at most k voxel diagonals, and
  // half a diagonal on at each end.
  constexpr double kVoxel = 0.005;
  const geometry::Shape sphere = geometry::Sphere{0.05};
  const Voxelmap map(*geometry::makeSurface(sphere), kVoxel, 20, 2);
  EXPECT_EQ(map.grid.size, Vector3i(61, 61, 61));
  forVoxels(map.grid, [&](const Vector3i& p, std::size_t) {
    const double d = geometry::distanceTo(sphere, map.grid.centre(p.x(), p.y(), p.z())).distance;
    const int steps = std::abs(map.at(p));
    ASSERT_TRUE(steps == 0 || (map.at(p) > 0) == (d < 0.0));
    ASSERT_GE(std::abs(d), (steps - 0.5) * kVoxel - 1e-12);
    ASSERT_LE(std::abs(d), (steps + 0.5) * std::sqrt(3.0) * kVoxel + 1e-12);
  });
}

TEST(Voxelmap, DoesNotDependOnThreads) {
  const auto surface = geometry::makeSurface(geometry::tessellate(geometry::Capsule{0.05, 0.1}, 1e-4));
  for (const std::size_t max_exact : {Voxelmap::kMaxExactVoxels, std::size_t{0}}) {
    const Voxelmap one(*surface, 0.004, 6, 1, max_exact);
    for (const int threads : {2, 3, 0}) {
      const Voxelmap more(*surface, 0.004, 6, threads, max_exact);
      forVoxels(one.grid, [&](const Vector3i& p, std::size_t) { ASSERT_EQ(more.at(p), one.at(p)); });
    }
  }
}

/// Grids that end anywhere in a tile: exact near the surface, and elsewhere as near as the slack says.
TEST(Voxelmap, TiledMatchesWhole) {
  const geometry::TriangleMesh link =
      mesh_file::loadMesh(testing::projectFile("data/robots/lwr/link2.stl")).mesh;
  const std::shared_ptr<const geometry::Surface> surfaces[] = {
      geometry::makeSurface(geometry::Sphere{0.05}),
      geometry::makeSurface(geometry::Cuboid{{0.1, 0.06, 0.02}}), geometry::makeSurface(link),
      geometry::makeSurface(hollowBall())};
  std::size_t far_inside = 0, far_outside = 0;
  for (const auto& surface : surfaces) {
    const double h = surface->bounds().extent().maxCoeff() / 150.0;
    for (const int outer_layers : {0, 60}) {
      const Voxelmap whole(*surface, h, outer_layers, 2), tiled(*surface, h, outer_layers, 2, 0);
      EXPECT_EQ(tiled.surface_voxels, whole.surface_voxels);
      EXPECT_EQ(tiled.solid_voxels, whole.solid_voxels);
      forVoxels(whole.grid, [&](const Vector3i& p, std::size_t) {
        const int layer = whole.at(p), slack = tiled.slack(p);
        ASSERT_LE(std::abs(tiled.at(p) - layer), slack) << p.transpose();
        ASSERT_TRUE(slack == 0 || std::abs(layer) > Voxelmap::kExactSteps);
        far_inside += slack > 0 && layer > 0;
        far_outside += slack > 0 && layer < 0;
      });
    }
  }
  EXPECT_GT(far_inside, 100'000u);
  EXPECT_GT(far_outside, 100'000u);
}

/// In cubes as all at once: shapes, a mesh, a mesh with a cavity, and grids that end anywhere in a cube.
TEST(VoxelCounts, MatchWholeGrid) {
  std::vector<std::shared_ptr<const geometry::Surface>> surfaces{
      geometry::makeSurface(hollowBall()),
      geometry::makeSurface(geometry::tessellate(geometry::Capsule{0.06, 0.1}, 1e-4))};
  for (const geometry::Shape& shape : testing::someShapes()) surfaces.push_back(geometry::makeSurface(shape));
  int with_inside = 0;
  for (const auto& surface : surfaces) {
    const double h = surface->bounds().extent().maxCoeff() / 110.0;
    const VoxelCounts whole = countVoxels(*surface, h, 2), cubes = countVoxels(*surface, h, 2, 0);
    EXPECT_EQ(cubes.surface, whole.surface);
    EXPECT_EQ(cubes.solid, whole.solid);
    with_inside += whole.solid > whole.surface;
  }
  EXPECT_GE(with_inside, 5) << "thin shapes have none";
}

TEST(Voxelmap, CavityIsOutside) {
  const Voxelmap map(*geometry::makeSurface(hollowBall()), 0.01, 2, 1);
  const auto layerAt = [&](const Vector3d& p) { return map.at(map.grid.voxelOf(p)); };
  EXPECT_LT(layerAt({0.0, 0.0, 0.0}), 0);
  EXPECT_GT(layerAt({0.075, 0.0, 0.0}), 0);
  EXPECT_LT(layerAt({0.12, 0.0, 0.0}), 0);
}

struct RealMesh {
  const char* file;
  bool doubtful;  // not watertight
};

class RealVoxelmap : public ::testing::TestWithParam<RealMesh> {};

TEST_P(RealVoxelmap, HasConsistentInside) {
  const auto file = testing::sharedData(std::string("meshes/") + GetParam().file);
  if (!exists(file)) GTEST_SKIP() << file;
  const auto surface = geometry::makeSurface(mesh_file::loadMesh(file).mesh);
  const double h = surface->bounds().extent().maxCoeff() / 70.0;
  const Voxelmap map(*surface, h, 2, 2);
  EXPECT_EQ(map.inside_doubtful, GetParam().doubtful);
  std::size_t different = 0, decided = 0;
  forVoxels(map.grid, [&](const Vector3i& p, std::size_t) {
    if (map.at(p) == 0) return;
    ++decided;
    different += (map.at(p) > 0) != surface->inside(map.grid.centre(p.x(), p.y(), p.z()));
  });
  // A piece that is closed at this resolution has one side, even where winding numbers waver near cracks.
  EXPECT_LE(different, GetParam().doubtful ? decided / 100 : 0);
  EXPECT_GT(map.solid_voxels, map.surface_voxels);
}

INSTANTIATE_TEST_SUITE_P(Real, RealVoxelmap,
                         ::testing::Values(RealMesh{"bunny.off", false}, RealMesh{"featuretype.STL", false},
                                           RealMesh{"not_convex.obj", true}, RealMesh{"halftunnel.off", true},
                                           RealMesh{"multibody.stl", true}),
                         [](const auto& p) { return std::string(p.param.file).substr(0, 5); });

}  // namespace voxelmap_test
}  // namespace abstand::field
