// Check of distances of pairs of shapes against closed forms.
#include "core/verify/closed_forms.hpp"

#include <array>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/math/quantile.hpp"
#include "core/math/random.hpp"
#include "core/verify/brute_force.hpp"
#include "core/verify/check_tools.hpp"

namespace abstand::verify {
namespace {

constexpr double kVoxel = 0.005;  // m
constexpr double kReach = 0.4;    // m, range of random positions
constexpr double kNear = 4.0;     // voxels: up to this distance the tolerance is tight
constexpr double kDeepest = 2.0;  // voxels, of overlapping poses
// Share 1 / kPart of options.poses: the brute force gets the most.
constexpr std::size_t kPart = 10;

// Bodies. The wall is so wide that its upper face (z = 0) acts as a half-space.
constexpr double kBallRadius = 0.05, kSmallBall = 0.03, kRod = 0.03, kRodLength = 0.15, kDrum = 0.04,
                 kDrumLength = 0.1;
const Vector3d kBox{0.1, 0.12, 0.14}, kEgg{0.04, 0.05, 0.09}, kSlabSize{1.6, 1.6, 0.2};
const Transform kWallPose = fromXyzRpy({0, 0, -0.1}, Vector3d::Zero());

enum Body { kBallBody, kSmallBallBody, kRodBody, kDrumBody, kBoxBody, kEggBody, kWallBody, kBodies };
const std::array<geometry::Shape, kBodies> kShapes{geometry::Sphere{kBallRadius},
                                                   geometry::Sphere{kSmallBall},
                                                   geometry::Capsule{kRod, kRodLength},
                                                   geometry::Cylinder{kDrum, kDrumLength},
                                                   geometry::Cuboid{kBox},
                                                   geometry::Ellipsoid{kEgg},
                                                   geometry::Cuboid{kSlabSize}};

/// Extent of a body below its centre, rotated by R.
double reachDown(Body body, const Matrix3d& R) {
  const Vector3d down = -R.transpose() * Vector3d::UnitZ();
  switch (body) {
    case kBallBody:
      return kBallRadius;
    case kSmallBallBody:
      return kSmallBall;
    case kRodBody:
      return kRod + 0.5 * kRodLength * std::abs(down.z());
    case kDrumBody:
      return kDrum * std::hypot(down.x(), down.y()) + 0.5 * kDrumLength * std::abs(down.z());
    case kBoxBody:
      return 0.5 * kBox.dot(down.cwiseAbs());
    default:
      return kEgg.cwiseProduct(down).norm();
  }
}

/// Distance (positive) from a point outside to a body at the origin.
double outsideDistance(Body body, const Vector3d& p) {
  const double from_axis = std::hypot(p.x(), p.y());
  switch (body) {
    case kBallBody:
      return p.norm() - kBallRadius;
    case kRodBody: {
      const double beyond = std::max(0.0, std::abs(p.z()) - 0.5 * kRodLength);
      return std::hypot(from_axis, beyond) - kRod;
    }
    case kDrumBody:
      return std::hypot(std::max(0.0, from_axis - kDrum), std::max(0.0, std::abs(p.z()) - 0.5 * kDrumLength));
    default:
      return (p.cwiseAbs() - 0.5 * kBox).cwiseMax(0.0).norm();
  }
}

/// A gives the points: it is the smaller of the two, or equal.
struct Case {
  const char* name;
  Body a, b;
  bool sharp{false};  ///< A has edges, which may lie between its points
};
constexpr std::array kCases{
    Case{"small ball and ball", kSmallBallBody, kBallBody},
    Case{"small ball and capsule", kSmallBallBody, kRodBody},
    Case{"small ball and cylinder", kSmallBallBody, kDrumBody},
    Case{"small ball and box", kSmallBallBody, kBoxBody},
    Case{"capsule and capsule", kRodBody, kRodBody},
    Case{"ball over wall", kBallBody, kWallBody},
    Case{"capsule over wall", kRodBody, kWallBody},
    Case{"cylinder over wall", kDrumBody, kWallBody, true},
    Case{"box over wall", kBoxBody, kWallBody, true},
    Case{"egg over wall", kEggBody, kWallBody},
};

struct Pose {
  std::size_t number;
  Transform X_WA, X_WB;
  double distance;
};

/// End points of a capsule's segment, in the world.
std::array<Vector3d, 2> axisOf(const Transform& X) {
  return {X * Vector3d(0, 0, -0.5 * kRodLength), X * Vector3d(0, 0, 0.5 * kRodLength)};
}

Pose randomCase(std::uint64_t seed, std::uint64_t index) {
  Random random(seed, index);
  Pose pose;
  pose.number = random.below(kCases.size());
  const Case& c = kCases[pose.number];
  pose.X_WA = pose.X_WB = Transform::Identity();
  pose.X_WA.linear() = random.rotation();
  if (c.b == kWallBody) {
    // Above the middle of the wall's face: slightly inside, near, or at a larger distance.
    const std::size_t kind = random.below(3);
    pose.distance = kind == 0   ? random.between(-kDeepest * kVoxel, 0.0)
                    : kind == 1 ? random.between(0.0, kNear * kVoxel)
                                : random.between(0.0, kReach);
    pose.X_WA.translation() = random.inCube(0.03);
    pose.X_WA.translation().z() = reachDown(c.a, pose.X_WA.linear()) + pose.distance;
    pose.X_WB = kWallPose;
  } else {
    // Separated: the surfaces at most touch.
    pose.X_WB.linear() = random.rotation();
    do {
      pose.X_WA.translation() = random.inCube(kReach);
      if (c.a == kRodBody) {
        const auto p = axisOf(pose.X_WA), q = axisOf(pose.X_WB);
        pose.distance = distanceSegments(p[0], p[1], q[0], q[1]) - 2.0 * kRod;
      } else {
        pose.distance = outsideDistance(c.b, pose.X_WB.inverse() * pose.X_WA.translation()) - kSmallBall;
      }
    } while (pose.distance < 0.0);
  }
  // Moves both together to a random place in a room.
  Transform X = Transform::Identity();
  X.linear() = random.rotation();
  X.translation() = random.inCube(2.0);
  pose.X_WA = X * pose.X_WA;
  pose.X_WB = X * pose.X_WB;
  return pose;
}

}  // namespace

std::vector<CheckResult> checkClosedForms(const VerifyOptions& options) {
  std::vector<CheckResult> results;
  const std::size_t poses = std::max<std::size_t>(options.poses / kPart, 1);
  for (const structure::FieldKind field :
       {structure::FieldKind::kLayered, structure::FieldKind::kFloat, structure::FieldKind::kMixed}) {
    std::array<std::shared_ptr<const structure::HapticStructure>, kBodies> bodies;
    for (std::size_t i = 0; i < kBodies; ++i)
      bodies[i] = structureOf(kShapes[i], field, kVoxel, options.threads);
    const double sharpness = field == structure::FieldKind::kLayered ? 1.0 : 0.25;  // voxels
    std::vector<double> errors(poses, kNaN), parts(poses, kNaN);
    std::vector<std::size_t> cases(poses, 0);
    parallelFor(options.threads, poses, [&](std::size_t i) {
      if (options.stop()) return;
      const Pose pose = randomCase(options.seed, i);
      const Case& c = kCases[pose.number];
      const query::PairResult r = query(*bodies[c.a], pose.X_WA, *bodies[c.b], pose.X_WB);
      const double error = std::abs(r.distance - pose.distance);
      const double edges = c.sharp ? bodies[c.a]->shell.covering_radius : 0.0;
      cases[i] = pose.number;
      errors[i] = error / kVoxel;
      parts[i] = error / (pose.distance <= kNear * kVoxel ? sharpness * kVoxel + edges : r.bound);
    });

    CheckResult result;
    result.name = "closed_form." + std::string(structure::fieldName(field));
    result.what =
        "Distances of balls, boxes, capsules, cylinders and eggs, apart and pressed into a wall, against "
        "closed forms; " +
        std::string(structure::fieldName(field)) + " fields, voxels and points of 5 mm.";
    result.quantity = "|distance - closed form| / allowed";
    result.reason =
        "Up to four voxels apart: a voxel with layers, a quarter of one with float distances, and the "
        "covering "
        "radius where an edge may lie between points. Beyond: the bound of the pair.";
    judge(result, parts, 1.0);
    result.table.header = {"bodies", "poses", "error p50 [voxels]", "error p99", "largest error"};
    for (std::size_t k = 0; k < kCases.size(); ++k) {
      std::vector<double> own;
      for (std::size_t i = 0; i < poses; ++i)
        if (cases[i] == k) own.push_back(errors[i]);
      result.table.rows.push_back(
          {kCases[k].name, std::to_string(own.size()), shortNumber(lowerQuantile(own, 0.5)),
           shortNumber(lowerQuantile(own, 0.99)), shortNumber(lowerQuantile(own, 1.0))});
    }
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace abstand::verify
