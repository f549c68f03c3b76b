// Robust Gauss-Newton steps, and their start poses.
#include "tracking/markers/marker_solver.hpp"

#include <Eigen/SVD>
#include <array>
#include <cmath>

namespace abstand::tracking {
namespace {

constexpr double kLimitWeight = 400.0;  // 1/rad^2: 3 degrees beyond cost as much as the soft tissue artefact
constexpr double kDamping = 0.05;       // 1/rad^2, 1/m^2; a marker 0.1 m from an axis gives 100
constexpr double kMaxTurn = 0.6;        // rad, m, for each step
constexpr double kAtRest = 2e-5;        // rad, m, convergence
constexpr double kStillness = 0.01;     // ratio of singular values; below it a rotation is undetermined
struct Stage {
  double reach;  // m
  int steps;
};
constexpr Stage kStages[]{{10.0, 25}, {0.30, 12}, {0.10, 10}, {0.05, 10}};

bool isSeen(const Vector3d& p) { return std::isfinite(p.x()); }

/// Rigid transform of the standing body's points onto the visible ones (Horn, by singular value
/// decomposition), for the markers selected by `use`; the identity about their means if they do not determine
/// it.
template <typename Use>
Transform align(const BodyRig& rig, std::span<const RigMarker> markers, std::span<const Vector3d> seen,
                Use use) {
  RigPlacement X_WS;
  place(rig, RigPose{}, X_WS);
  Vector3d mean_rest = Vector3d::Zero(), mean_seen = Vector3d::Zero();
  int count = 0;
  for (std::size_t i = 0; i < markers.size(); ++i) {
    if (!isSeen(seen[i]) || !use(markers[i].segment)) continue;
    mean_rest += X_WS[index(markers[i].segment)] * markers[i].p_S;
    mean_seen += seen[i];
    ++count;
  }
  Transform X = Transform::Identity();
  if (count == 0) return X;
  mean_rest /= count;
  mean_seen /= count;
  Matrix3d sum = Matrix3d::Zero();
  for (std::size_t i = 0; i < markers.size(); ++i)
    if (isSeen(seen[i]) && use(markers[i].segment))
      sum +=
          (seen[i] - mean_seen) * (X_WS[index(markers[i].segment)] * markers[i].p_S - mean_rest).transpose();
  const Eigen::JacobiSVD<Matrix3d> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  if (count >= 3 && svd.singularValues()[1] > kStillness * svd.singularValues()[0]) {
    const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
    X.linear() = svd.matrixU() * Vector3d(1.0, 1.0, sign).asDiagonal() * svd.matrixV().transpose();
  }
  X.translation() = mean_seen - X.linear() * mean_rest;
  return X;
}

}  // namespace

double markerWeight(double distance, double reach) {
  const double u = distance / reach, v = 1.0 + u * u;
  return 1.0 / (kSkinMotion * kSkinMotion * v * v);
}

MarkerPose MarkerSolver::solve(std::span<const RigMarker> markers, std::span<const Vector3d> seen,
                               const RigPose& start, const PoseHold& hold, double reach, int max_steps) {
  MarkerPose out;
  out.pose = start;
  BodySolver::Vector to_last = BodySolver::Vector::Zero();
  if (hold.last && hold.turn > 0.0) to_last.setConstant(1.0 / (hold.turn * hold.turn));
  RigPose standing;
  for (int i = 0; i < max_steps; ++i) {
    solver_.begin(out.pose);
    for (std::size_t k = 0; k < markers.size(); ++k) {
      if (!isSeen(seen[k])) continue;
      const RigSegment s = markers[k].segment;
      const Vector3d p_W = solver_.placement()[index(s)] * markers[k].p_S;
      solver_.addPoint(s, p_W, seen[k], markerWeight((p_W - seen[k]).norm(), reach));
    }
    if (hold.last) solver_.addPrior(*hold.last, to_last);
    standing.X_WP = out.pose.X_WP;
    solver_.addPrior(standing, hold.to_rest);
    solver_.addLimits(kLimitWeight);
    const double moved = solver_.step(kDamping, kMaxTurn);
    out.pose = solver_.pose();
    if (moved < kAtRest) break;
  }
  RigPlacement X_WS;
  place(*rig_, out.pose, X_WS);
  double sum = 0.0;
  for (std::size_t k = 0; k < markers.size(); ++k) {
    if (!isSeen(seen[k])) continue;
    ++out.seen;
    const double square = (X_WS[index(markers[k].segment)] * markers[k].p_S - seen[k]).squaredNorm();
    out.cost += square / (1.0 + square / (reach * reach));
    if (square > kMisplaced * kMisplaced)
      ++out.misplaced;
    else
      sum += square;
  }
  const int fit = out.seen - out.misplaced;
  out.rms = fit > 0 ? std::sqrt(sum / fit) : kInfinity;
  return out;
}

MarkerPose MarkerSolver::search(std::span<const RigMarker> markers, std::span<const Vector3d> seen,
                                const PoseHold& hold) {
  const auto all = [](RigSegment) { return true; };
  const auto trunk = [](RigSegment s) { return s == RigSegment::kPelvis || s == RigSegment::kChest; };
  const auto pelvis = [](RigSegment s) { return s == RigSegment::kPelvis; };
  std::array<Transform, 7> starts{align(*rig_, markers, seen, all), align(*rig_, markers, seen, trunk),
                                  align(*rig_, markers, seen, pelvis)};
  for (int k = 0; k < 4; ++k) {
    Transform& X = starts[static_cast<std::size_t>(k) + 3];
    X.linear() = Eigen::AngleAxisd(0.5 * kPi * k, Vector3d::UnitZ()).toRotationMatrix();
    X.translation() = starts[0].translation();
  }
  MarkerPose best;
  best.cost = kInfinity;
  for (const Transform& X_WP : starts) {
    RigPose pose;
    pose.X_WP = X_WP;
    MarkerPose found;
    for (const Stage& stage : kStages) {
      found = solve(markers, seen, pose, hold, stage.reach, stage.steps);
      pose = found.pose;
    }
    if (found.cost < best.cost) best = found;
  }
  return best;
}

}  // namespace abstand::tracking
