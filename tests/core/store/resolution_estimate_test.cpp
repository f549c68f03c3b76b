// What --explain predicts, against what is then built.
#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "core/mesh_file/mesh_file.hpp"
#include "core/store/resolution_estimate.hpp"
#include "tests/support/paths.hpp"

namespace abstand::store {
namespace resolution_estimate_test {

// As ResolutionProbe promises.
constexpr double kFactor = 1.25;
// The covering radius is promised as 1.1 spacings; shells get by with 0.85 and more.
constexpr double kBoundFactor = 1.35;

struct Case {
  const char* what;
  std::shared_ptr<const geometry::Surface> surface;
  structure::HapticOptions options;
};

TEST(ResolutionProbe, PredictionMatchesBuild) {
  const auto mesh = [](const char* file) -> std::shared_ptr<const geometry::Surface> {
    return geometry::makeSurface(mesh_file::loadMesh(testing::projectFile(file)).mesh);
  };
  const auto shape = [](const geometry::Shape& s) -> std::shared_ptr<const geometry::Surface> {
    return geometry::makeSurface(s);
  };
  const auto both = [](double pitch, structure::FieldKind field = structure::FieldKind::kMixed) {
    return structure::HapticOptions{.voxel_size = pitch, .point_spacing = pitch, .field = field};
  };
  const auto ball = shape(geometry::Sphere{0.05});
  const auto plate = shape(geometry::Cuboid{{0.4, 0.3, 0.02}});
  const auto link = mesh("data/robots/lwr/link1.stl"), base = mesh("data/robots/lwr/base.stl");
  const Case cases[] = {
      {"ball, 2.5 mm", ball, both(0.0025)},
      {"ball, 2 mm, layered", ball, both(0.002, structure::FieldKind::kLayered)},
      {"large ball, in tiles, layered",
       shape(geometry::Sphere{0.5}),
       {.voxel_size = 0.0027, .point_spacing = 0.03, .field = structure::FieldKind::kLayered}},
      {"ball, 2 mm, float", ball, both(0.002, structure::FieldKind::kFloat)},
      {"ball, coarser than the probe", ball, both(0.01)},
      {"ball, few outer layers", ball, {.voxel_size = 0.002, .point_spacing = 0.004, .outer_layers = 2}},
      {"plate, 5 mm", plate, both(0.005)},
      {"plate, fine points", plate, {.voxel_size = 0.02, .point_spacing = 0.004}},
      {"plate, fine voxels", plate, {.voxel_size = 0.004, .point_spacing = 0.02}},
      {"link, 5 mm", link, both(0.005)},
      {"link, 3 mm", link, both(0.003)},
      {"base, 5 mm", base, both(0.005)},
  };
  for (const Case& c : cases) {
    ResolutionProbe probe(c.surface);
    const ResolutionEstimate e = probe.estimate(c.options);
    const auto built = structure::buildHapticStructure(c.what, c.surface, c.options);
    EXPECT_EQ(e.refused, "");
    EXPECT_LT(e.points, kFactor * double(built->shell.size())) << c.what;
    EXPECT_GT(e.points, double(built->shell.size()) / kFactor) << c.what;
    EXPECT_LT(e.memory_bytes, kFactor * double(built->memoryBytes())) << c.what;
    EXPECT_GT(e.memory_bytes, double(built->memoryBytes()) / kFactor) << c.what;
    EXPECT_GE(e.error_bound, built->errorBound()) << c.what;
    EXPECT_LE(e.error_bound, kBoundFactor * built->errorBound()) << c.what;
    EXPECT_GT(e.build_ms, 0.0);
    EXPECT_GT(e.distance_us, 0.0);
    EXPECT_GE(e.contact_us, e.distance_us);
  }
}

TEST(ResolutionProbe, FinerResolutionCostsMoreAndErrsLess) {
  ResolutionProbe probe(geometry::makeSurface(geometry::Capsule{0.05, 0.3}));
  ResolutionEstimate last;
  for (const double pitch : {0.005, 0.004, 0.002, 0.001}) {
    const ResolutionEstimate e = probe.estimate({.voxel_size = pitch, .point_spacing = pitch});
    EXPECT_EQ(e.refused, "");
    if (last.points > 0.0) {
      EXPECT_GT(e.points, last.points);
      EXPECT_GT(e.memory_bytes, last.memory_bytes);
      EXPECT_LT(e.error_bound, last.error_bound);
      EXPECT_GT(e.build_ms, last.build_ms);
    }
    last = e;
  }
}

TEST(ResolutionProbe, ReportsRejectedResolutions) {
  const std::shared_ptr<const geometry::Surface> hall =
      geometry::makeSurface(geometry::Cuboid{{10.0, 10.0, 4.0}});
  ResolutionProbe probe(hall);
  const structure::HapticOptions tiny{.voxel_size = 0.001, .point_spacing = 0.5};
  EXPECT_NE(probe.estimate(tiny).refused.find("voxels"), std::string::npos);
  EXPECT_THROW(structure::buildHapticStructure("hall", hall, tiny), UsageError);
  const structure::HapticOptions dense{
      .voxel_size = 0.008, .point_spacing = 0.5, .field = structure::FieldKind::kFloat};
  EXPECT_NE(probe.estimate(dense).refused.find("2 GB"), std::string::npos);
  EXPECT_THROW(probe.estimate({.voxel_size = -1.0}), UsageError);
}

TEST(ResolutionProbe, CanBeInterrupted) {
  ResolutionProbe probe(geometry::makeSurface(geometry::Sphere{0.05}));
  structure::BuildMonitor monitor;
  monitor.cancelled = [] { return true; };
  EXPECT_THROW(probe.estimate({}, monitor), structure::BuildCancelled);
}

}  // namespace resolution_estimate_test
}  // namespace abstand::store
