// Real meshes and the meshes of real robots.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.hpp"
#include "core/geometry/mass_properties.hpp"
#include "core/mesh_file/mesh_file.hpp"
#include "tests/support/paths.hpp"

namespace abstand::mesh_file {
namespace mesh_data_test {

using testing::sharedData;

struct Known {
  const char* file;
  std::size_t triangles, vertices, open_edges, non_manifold_edges, flipped_edges;
  Vector3d extent;
  double volume;  ///< of closed meshes; else 0
};

class RealMesh : public ::testing::TestWithParam<Known> {};

/// The lists give extents and volumes with four to six digits.
constexpr double kListed = 1e-3;

TEST_P(RealMesh, MatchesKnownProperties) {
  const auto& known = GetParam();
  const auto file = sharedData(std::string("meshes/") + known.file);
  if (!exists(file)) GTEST_SKIP() << file;
  const auto loaded = loadMesh(file);
  const auto& r = loaded.report;
  EXPECT_EQ(r.triangles, known.triangles);
  EXPECT_EQ(r.vertices, known.vertices);
  EXPECT_EQ(r.open_edges, known.open_edges);
  EXPECT_EQ(r.non_manifold_edges, known.non_manifold_edges);
  EXPECT_EQ(r.flipped_edges, known.flipped_edges);
  EXPECT_EQ(r.degenerate_triangles, 0u);
  EXPECT_EQ(r.watertight, known.open_edges + known.non_manifold_edges + known.flipped_edges == 0);
  EXPECT_LE((r.extent - known.extent).norm(), kListed * known.extent.norm());
  if (known.volume > 0.0) {
    EXPECT_NEAR(r.volume, known.volume, kListed * known.volume);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Files, RealMesh,
    ::testing::Values(
        Known{"20mm-xyz-cube.stl", 260, 132, 0, 0, 0, {20, 20, 20}, 0},
        Known{"2triangles.off", 2, 4, 4, 0, 0, {2, 1, 1}, 0},
        Known{"ballA.off", 3796, 1900, 0, 0, 0, {13.8274, 13.8425, 13.8543}, 1401},
        Known{"bunny.off", 6966, 3485, 0, 0, 0, {0.1558, 0.1544, 0.1208}, 0.0007539},
        Known{"busted.STL", 3878, 1941, 0, 0, 0, {10.6755, 11.3847, 9.5724}, 0},
        Known{"cube.obj", 12, 8, 0, 0, 0, {1, 1, 1}, 1},
        Known{"dragon.obj", 79988, 39994, 0, 0, 0, {2.4957, 1.7631, 1.1153}, 0.8672},
        // 576 half-edges are open for exact comparison; they lie within single precision of each other
        Known{"featuretype.STL", 3476, 1722, 0, 0, 0, {5, 2.5, 1.375}, 0},
        Known{"fuze_ascii.ply", 1000, 502, 0, 0, 0, {0.072612, 0.073514, 0.215128}, 0},
        // 784 quads
        Known{"halftunnel.off", 1568, 831, 96, 0, 0, {8.6523, 5.9452, 12.295}, 0},
        Known{"multibody.stl", 32, 20, 0, 0, 12, {0.636032, 1.08843, 0.339928}, 0},
        Known{"not_convex.obj", 96, 44, 0, 12, 0, {0.366, 0.762, 0.762}, 0.03081},
        Known{"unit_sphere.STL", 1280, 642, 0, 0, 0, {2, 2, 2}, 0},
        // concave polygons of up to 11 corners, with collinear ones
        Known{"wallhole.obj", 66, 35, 0, 0, 0, {10, 15, 10}, 0}),
    [](const auto& i) {
      std::string name = i.param.file;
      std::replace_if(
          name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
      return name;
    });

TEST(RealMeshes, RejectsPointsWithoutFaces) {
  const auto file = sharedData("meshes/points_emptyface.ply");
  if (!exists(file)) GTEST_SKIP() << file;
  EXPECT_THROW(loadMesh(file), ParseError);
}

TEST(RealMeshes, ReadsRobotMeshes) {
  const auto folder = sharedData("robots");
  if (!exists(folder)) GTEST_SKIP() << folder;
  std::size_t read = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    std::string extension = entry.path().extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension != ".stl" && extension != ".obj" && extension != ".dae") continue;
    SCOPED_TRACE(entry.path());
    const auto loaded = loadMesh(entry.path());
    EXPECT_GT(loaded.report.triangles, 3u);
    EXPECT_GT(geometry::surfaceArea(loaded.mesh), 0.0);
    // metres, or NAO's decimetres
    EXPECT_LT(loaded.report.extent.maxCoeff(), 10.0);
    EXPECT_GT(loaded.report.extent.maxCoeff(), 0.01);
    ++read;
  }
  EXPECT_GT(read, 100u);
}

TEST(RealMeshes, LinkIsSameInStlAndCollada) {
  const auto dae = sharedData("robots/kuka_lwr4plus/arm_segment_a.dae");
  const auto stl = sharedData("robots/kuka_lwr4plus/meshes_arm/arm_segment_a.stl");
  if (!exists(dae) || !exists(stl)) GTEST_SKIP() << dae;
  const auto a = loadMesh(dae), b = loadMesh(stl);
  EXPECT_EQ(a.mesh.triangles.size(), b.mesh.triangles.size());
  EXPECT_LE((geometry::bounds(a.mesh).lower - geometry::bounds(b.mesh).lower).norm(),
            1e-6);  // written with six digits
  EXPECT_LE((geometry::bounds(a.mesh).upper - geometry::bounds(b.mesh).upper).norm(), 1e-6);
  EXPECT_NEAR(geometry::surfaceArea(a.mesh), geometry::surfaceArea(b.mesh), 1e-6);
}

}  // namespace mesh_data_test
}  // namespace abstand::mesh_file
