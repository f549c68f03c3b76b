// Memory of fine maps goes with the surface: about 1,024 cells along an axis.
#include <gtest/gtest.h>

#include <fstream>

#include "core/mesh_file/mesh_file.hpp"
#include "core/structure/haptic_structure.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/paths.hpp"

namespace abstand::testing {
namespace fine_map_test {

constexpr std::size_t kMaxBytes = 200'000'000;
constexpr double kMaxBytesBuilding = 400e6;

/// Bytes of this process in memory: now, or the most since the last reset.
double residentBytes(const char* which) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind(which, 0) == 0) return 1024.0 * std::stod(line.substr(line.find(':') + 1));
  return kNaN;
}
void resetPeak() { std::ofstream("/proc/self/clear_refs") << "5"; }

geometry::TriangleMesh torus(double radius, double tube, int around, int across) {
  geometry::TriangleMesh mesh;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double a = 2.0 * kPi * i / around, b = 2.0 * kPi * j / across, r = radius + tube * std::cos(b);
      mesh.vertices.push_back({r * std::cos(a), r * std::sin(a), tube * std::sin(b)});
    }
  }
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(i % around * across + j % across); };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

/// Layers against the exact distance: steps leave so many whole voxels between, and lead along diagonals at
/// most; on either way half a diagonal is lost at each end.
void expectLayers(const structure::HapticStructure& s) {
  const field::Voxelmap& map = *s.voxelmap;
  const geometry::Bounds box = s.surface->bounds();
  const double h = map.grid.voxel_size;
  int exact = 0, far_inside = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vector3d p = box.centre() + randomPoint(i, 0.5).cwiseProduct(box.extent());
    const Vector3i v = map.grid.voxelOf(p);
    const double d = s.surface->signedDistance(map.grid.centre(v.x(), v.y(), v.z()));
    const int layer = map.at(v), slack = map.slack(v), steps = std::abs(layer);
    ASSERT_TRUE(layer == 0 || (layer > 0) == (d < 0.0)) << d;
    ASSERT_GE(std::abs(d), (steps - slack - 0.5) * h - 1e-9);
    ASSERT_LE(std::abs(d), (steps + slack + 0.5) * std::sqrt(3.0) * h + 1e-9);
    exact += slack == 0;
    far_inside += slack > 0 && layer > 0;
  }
  EXPECT_GT(exact, 10);
  EXPECT_GT(far_inside, 100);
}

/// Builds a body with so many cells along its longest axis, outer layers included, and looks at its memory
/// and at its distances.
void expectSmall(const std::shared_ptr<const geometry::Surface>& surface, int cells,
                 structure::FieldKind field = structure::FieldKind::kMixed) {
  const geometry::Bounds box = surface->bounds();
  const double size = box.extent().maxCoeff();
  structure::HapticOptions options;
  options.field = field;
  options.voxel_size = size / (cells - 1 - 2 * options.outer_layers + 0.5);
  options.point_spacing = size / 100.0;
  resetPeak();
  const double before = residentBytes("VmRSS");
  const auto s = structure::buildHapticStructure("body", surface, options, 2);
  const double peak = residentBytes("VmHWM") - before;
  EXPECT_EQ(s->grid.size.maxCoeff(), cells);
  EXPECT_LT(s->memoryBytes(), kMaxBytes);
  EXPECT_LT(peak, kMaxBytesBuilding);
  ::testing::Test::RecordProperty("memory_mb", std::to_string(1e-6 * double(s->memoryBytes())));
  ::testing::Test::RecordProperty("peak_mb", std::to_string(1e-6 * peak));
  std::printf("%zu MB, %.0f MB more while building, %.1f s\n", s->memoryBytes() / 1'000'000, 1e-6 * peak,
              1e-3 * s->build_ms);
  EXPECT_GT(s->solid_voxels, s->surface_voxels);
  if (field == structure::FieldKind::kLayered) return expectLayers(*s);
  int deep = 0, near = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vector3f p = (box.centre() + randomPoint(i, 0.5).cwiseProduct(box.extent())).cast<float>();
    const double exact = surface->signedDistance(p.cast<double>());
    float sample = 0.0f;
    if (!s->near_field->sample(p.x(), p.y(), p.z(), sample)) {
      ASSERT_GT(exact, 0.0);
    } else if (s->near_field->deep(p.x(), p.y(), p.z())) {
      ASSERT_NEAR(sample, exact, s->near_field->deepErrorBound());
      ++deep;
    } else {
      ASSERT_NEAR(sample, exact, s->near_field->errorBound());
      ++near;
    }
  }
  EXPECT_GT(deep, 100);
  EXPECT_GT(near, 10);
}

TEST(FineMap, BallIsSmall) { expectSmall(geometry::makeSurface(geometry::Sphere{0.5}), 1025); }
TEST(FineMap, LayeredBallIsSmall) {
  expectSmall(geometry::makeSurface(geometry::Sphere{0.5}), 1025, structure::FieldKind::kLayered);
}
TEST(FineMap, CuboidIsSmall) { expectSmall(geometry::makeSurface(geometry::Cuboid{{1.0, 0.6, 0.4}}), 1024); }
TEST(FineMap, LinkIsSmall) {
  const geometry::TriangleMesh link = mesh_file::loadMesh(projectFile("data/robots/lwr/link2.stl")).mesh;
  expectSmall(geometry::makeSurface(link), 1024);
}
TEST(FineMap, LayeredLinkIsSmall) {
  const geometry::TriangleMesh link = mesh_file::loadMesh(projectFile("data/robots/lwr/link2.stl")).mesh;
  expectSmall(geometry::makeSurface(link), 1024, structure::FieldKind::kLayered);
}
TEST(FineMap, TorusIsSmall) { expectSmall(geometry::makeSurface(torus(0.3, 0.1, 96, 48)), 1024); }

}  // namespace fine_map_test
}  // namespace abstand::testing
