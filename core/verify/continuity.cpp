// Check of the continuity of forces under small steps.
#include "core/verify/continuity.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/verify/check_tools.hpp"
#include "core/verify/meshes.hpp"

namespace abstand::verify {
namespace {

constexpr double kPressVoxel = 0.005;  // m, also the point spacing
constexpr double kPartOfVoxel = 0.1;
constexpr double kPressStiffness = 1e6;  // N/m^3
const double kSteepest = std::sqrt(3.0);

/// A moves on a straight line; B is at the origin.
struct Path {
  std::string name, what;
  std::shared_ptr<const geometry::Surface> a, b;
  Transform start;
  Vector3d displacement;
};

std::vector<Path> somePaths() {
  const auto block = [] {
    return geometry::makeSurface(geometry::Shape{geometry::Cuboid{{0.2, 0.2, 0.08}}});
  };
  std::vector<Path> paths;
  paths.push_back({"press", "a ball pressed straight into a block, from 5 mm above to 10 mm deep",
                   geometry::makeSurface(geometry::Shape{geometry::Sphere{0.04}}), block(),
                   fromXyzRpy({0.0031, 0.0017, 0.085}, {0.3, 0.2, 0.1}), Vector3d(0, 0, -0.015)});
  paths.push_back({"slide", "a ball that slides aslant over a block, 6 mm deep",
                   geometry::makeSurface(geometry::Shape{geometry::Sphere{0.04}}), block(),
                   fromXyzRpy({-0.03, -0.02, 0.074}, {0.3, 0.2, 0.1}), Vector3d(0.05, 0.03, 0)});
  paths.push_back({"corner", "a cube's corner that ploughs through a block, 12 mm deep, and over its rim",
                   geometry::makeSurface(geometry::Shape{geometry::Cuboid{{0.06, 0.06, 0.06}}}), block(),
                   fromXyzRpy({0.04, -0.01, 0.04 + 0.03 * std::sqrt(3.0) - 0.012},
                              {kPi / 4, std::atan(std::sqrt(0.5)), 0.2}),
                   Vector3d(0.07, 0.01, 0)});
  paths.push_back({"star", "a star that slides over a ball, to and fro of its tips",
                   geometry::makeSurface(starMesh(0.02, 0.05)),
                   geometry::makeSurface(geometry::Shape{geometry::Sphere{0.08}}),
                   fromXyzRpy({-0.03, 0.01, 0.11}, {0.4, 0.7, 0.2}), Vector3d(0.06, 0.004, 0)});
  return paths;
}

struct Jumps {
  std::vector<double> displacement, force;  ///< m, N
  double largest{0.0};                      ///< N, |difference of two forces|
  double possible{0.0};                     ///< N
  double peak{0.0};                         ///< N
};

Jumps follow(const Path& path, structure::FieldKind field, const VerifyOptions& options) {
  const structure::HapticOptions build{
      .voxel_size = kPressVoxel, .point_spacing = kPressVoxel, .outer_layers = kOuterLayers, .field = field};
  const auto a = structure::buildHapticStructure("a", path.a, build, options.threads);
  const auto b = structure::buildHapticStructure("b", path.b, build, options.threads);
  const double step = kPartOfVoxel * kPressVoxel;
  const auto steps = static_cast<std::size_t>(path.displacement.norm() / step);
  std::vector<Vector3d> forces(steps + 1);
  std::vector<double> areas(steps + 1, 0.0);
  const bool from_a = query::pointsFromA(*a, *b);
  const structure::HapticStructure &P = from_a ? *a : *b, &F = from_a ? *b : *a;
  parallelFor(options.threads, steps + 1, [&](std::size_t i) {
    Transform X_WA = path.start;
    X_WA.translation() += path.displacement.normalized() * (step * static_cast<double>(i));
    forces[i] = query(*a, X_WA, *b, Transform::Identity(), {.stiffness = kPressStiffness}).force_a;
    // Area of all points that are below the surface, or get there in one step, within the field's error.
    const Transform X_FP = from_a ? X_WA : Transform(X_WA.inverse());
    for (std::size_t k = 0; k < P.shell.size(); ++k)
      if (F.surface->signedDistance(X_FP * P.shell.point(k)) < 0.5 * kSteepest * kPressVoxel + step)
        areas[i] += static_cast<double>(P.shell.area[k]);
  });
  Jumps jumps;
  for (std::size_t i = 0; i <= steps; ++i) {
    jumps.displacement.push_back(step * static_cast<double>(i));
    jumps.force.push_back(forces[i].norm());
    jumps.peak = std::max(jumps.peak, forces[i].norm());
    if (i > 0) jumps.largest = std::max(jumps.largest, (forces[i] - forces[i - 1]).norm());
  }
  jumps.possible = kPressStiffness * kSteepest * step * *std::ranges::max_element(areas);
  return jumps;
}

}  // namespace

std::vector<CheckResult> checkContinuity(const VerifyOptions& options) {
  std::vector<CheckResult> results;
  for (const Path& path : somePaths()) {
    CheckResult result;
    result.name = "continuity." + path.name;
    result.what = "Steps of a tenth of a voxel: " + path.what + ". Voxels and points of 5 mm.";
    result.quantity = "largest jump / the jump possible in a continuous field";
    result.reason =
        "Stiffness times pressed area times sqrt(3) times step: trilinear fields of distances are no "
        "steeper. Layers have no such limit.";
    result.table.header = {"field", "largest jump [N]", "of the largest force", "of the possible jump",
                           "largest force [N]"};
    Plot plot{"Force along the path: " + path.name, "displacement [m]", "force [N]", false, false, {}};
    std::vector<double> parts;
    std::size_t poses = 0;
    for (const structure::FieldKind field :
         {structure::FieldKind::kLayered, structure::FieldKind::kFloat, structure::FieldKind::kMixed}) {
      if (options.stop()) break;
      const Jumps jumps = follow(path, field, options);
      poses += jumps.displacement.size();
      const double part = jumps.peak > 0.0 ? jumps.largest / jumps.possible : kNaN;
      if (field != structure::FieldKind::kLayered) parts.push_back(part);
      result.table.rows.push_back({std::string(structure::fieldName(field)), shortNumber(jumps.largest),
                                   shortNumber(jumps.largest / jumps.peak), shortNumber(part),
                                   shortNumber(jumps.peak)});
      plot.series.push_back({std::string(structure::fieldName(field)), jumps.displacement, jumps.force});
    }
    judge(result, parts, 1.0);
    result.poses = poses;
    result.passed = result.passed && parts.size() == 2;
    result.plots.push_back(std::move(plot));
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace abstand::verify
