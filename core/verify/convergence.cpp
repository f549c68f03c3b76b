// Check of the convergence order of forces with resolution.
#include "core/verify/convergence.hpp"

#include <array>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/math/random.hpp"
#include "core/verify/check_tools.hpp"
#include "core/verify/closed_contact.hpp"
#include "core/verify/statistics.hpp"

namespace abstand::verify {
namespace {

constexpr std::array kSteps{0.01, 0.00707, 0.005, 0.00354, 0.0025};  // m
constexpr double kStiffness = 1e6;                                   // N/m^3
constexpr double kRadius = 0.05, kOtherRadius = 0.08;                // m, radii
// m; the depth varies, so that the positions relative to grid and points do
constexpr double kMinDepth = 0.012, kMaxDepth = 0.02;
const Vector3d kWallSize{0.18, 0.18, 0.08};
// For layers: walls of several thicknesses, so that their faces have all positions in their voxels, equally
// at every step.
constexpr int kWalls = 8;
// Tolerance of a measured order: poses are random, and the coarsest steps are not small relative to the
// depth.
constexpr double kOrderNoise = 0.1;
constexpr std::size_t kPoses = 200, kFewPoses = 40;

enum class Against { kBall, kWall };

/// Thickness of a wall. Every second one is a whole number of voxels; the grid is centred on the wall, so
/// that its faces move by half.
double thicknessOf(int wall, double h) {
  return 2.0 * h * (std::round(kWallSize.z() / (2.0 * h)) + (wall + 0.5) / kWalls);
}

/// True force on the ball, and its random pose.
struct Press {
  int wall{0};
  Transform X_WA{Transform::Identity()};
  Vector3d force;
};

Press randomPress(Against against, int walls, double h, std::uint64_t seed, std::uint64_t index) {
  Random random(seed, index);
  const double depth = random.between(kMinDepth, kMaxDepth);
  Press press;
  press.X_WA.linear() = random.rotation();
  if (against == Against::kBall) {
    const double apart = kRadius + kOtherRadius - depth;
    const Vector3d out = random.direction();
    press.X_WA.translation() = apart * out;
    press.force = kStiffness * ballInBallForce(kRadius, kOtherRadius, apart) * out;
  } else {
    // In the middle of the face, away from its edges.
    press.wall = static_cast<int>(index) % walls;
    press.X_WA.translation() = random.inCube(0.01);
    press.X_WA.translation().z() = 0.5 * thicknessOf(press.wall, h) + kRadius - depth;
    press.force = kStiffness * capVolume(kRadius, depth) * Vector3d::UnitZ();
  }
  return press;
}

double relativeError(Against against, structure::FieldKind field, double h, const VerifyOptions& options) {
  const auto ball = structureOf(geometry::Sphere{kRadius}, field, h, options.threads);
  std::vector<std::shared_ptr<const structure::HapticStructure>> others;
  const int walls = field == structure::FieldKind::kLayered ? kWalls : 1;
  if (against == Against::kBall) {
    others.push_back(structureOf(geometry::Sphere{kOtherRadius}, field, h, options.threads));
  } else {
    for (int wall = 0; wall < walls; ++wall)
      others.push_back(structureOf(geometry::Cuboid{{kWallSize.x(), kWallSize.y(), thicknessOf(wall, h)}},
                                   field, h, options.threads));
  }
  std::vector<double> errors(options.quick ? kFewPoses : kPoses);
  parallelFor(options.threads, errors.size(), [&](std::size_t i) {
    const Press press = randomPress(against, walls, h, options.seed, i);
    const query::PairResult r = query(*ball, press.X_WA, *others[static_cast<std::size_t>(press.wall)],
                                      Transform::Identity(), {.stiffness = kStiffness});
    errors[i] = (r.force_a - press.force).norm() / press.force.norm();
  });
  return rms(errors);
}

}  // namespace

std::vector<CheckResult> checkConvergence(const VerifyOptions& options) {
  std::vector<CheckResult> results;
  Plot plot{"Error of the force against resolution",
            "voxel and point spacing h [m]",
            "relative error, rms",
            true,
            true,
            {}};
  for (const Against against : {Against::kBall, Against::kWall}) {
    const std::string scene = against == Against::kBall ? "ball in ball" : "ball in wall";
    for (const structure::FieldKind field :
         {structure::FieldKind::kLayered, structure::FieldKind::kFloat, structure::FieldKind::kMixed}) {
      Series series{scene + ", " + std::string(structure::fieldName(field)), {}, {}};
      CheckResult result;
      result.name = std::string("convergence.") + (against == Against::kBall ? "ball." : "wall.") +
                    std::string(structure::fieldName(field));
      result.table.header = {"h [mm]", "relative error of the force, rms"};
      for (const double h : kSteps) {
        if (options.stop()) break;
        const double error = relativeError(against, field, h, options);
        series.x.push_back(h);
        series.y.push_back(error);
        result.table.rows.push_back({shortNumber(1e3 * h), shortNumber(error)});
      }
      result.what = "Force of a " + scene + ", " + std::string(structure::fieldName(field)) +
                    " fields, against the closed form, over five resolutions with random poses each.";
      result.quantity = "minus the order of convergence";
      // Layers are steps to any of 26 neighbours, so on inclined surfaces they count up to sqrt(3) times too
      // few voxels at any resolution: against the ball the error remains, and is only plotted.
      if (field == structure::FieldKind::kLayered && against == Against::kBall) {
        plot.series.push_back(std::move(series));
        continue;
      }
      const double order = field == structure::FieldKind::kLayered ? 1.0 : 2.0;
      result.reason = field == structure::FieldKind::kLayered
                          ? "Layers are whole voxels along a wall's normal: errors shrink as h."
                          : "Trilinear distances and the points' weights err as h squared on smooth bodies.";
      result.reason += " " + shortNumber(kOrderNoise) +
                       " less, as poses are random and the coarsest steps not small against the depth.";
      std::vector<double> measured;
      if (series.x.size() == kSteps.size()) measured.push_back(-logSlope(series.x, series.y));
      judge(result, measured, kOrderNoise - order);
      result.poses = kSteps.size() * (options.quick ? kFewPoses : kPoses);
      plot.series.push_back(std::move(series));
      results.push_back(std::move(result));
    }
  }
  results.front().plots.push_back(std::move(plot));
  return results;
}

}  // namespace abstand::verify
