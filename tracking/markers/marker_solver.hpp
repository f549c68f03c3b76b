// One pose of a rig from one moment of markers.
#pragma once

#include <optional>
#include <span>

#include "tracking/body/body_solver.hpp"

namespace abstand::tracking {

/// A marker that is fixed to a segment, at p_S (m).
struct RigMarker {
  RigSegment segment{RigSegment::kPelvis};
  Vector3d p_S{Vector3d::Zero()};
};

/// Skin moves on bones by about this (m): the standard deviation of a marker that is where it belongs.
inline constexpr double kSkinMotion = 0.010;
/// A marker farther than this (m) from where the body has it is not that marker: swapped, a ghost, fallen
/// off.
inline constexpr double kMisplaced = 0.060;

/// How hard a pose is held where markers say nothing.
struct PoseHold {
  std::optional<RigPose> last;  ///< the pose before this one
  double turn{0.0};             ///< rad, m: what a freedom may change by since then
  BodySolver::Vector to_rest{BodySolver::Vector::Zero()};  ///< 1/rad^2, towards standing
};

struct MarkerPose {
  RigPose pose;
  double cost{0.0};  ///< of the misfit, bounded for each marker; without limits and hold
  double rms{0.0};   ///< m, over the markers that are not misplaced; infinite where there are none
  int seen{0}, misplaced{0};
};

/// Least squares over the markers that are seen, by Gauss-Newton with bounded (Geman-McClure) weights: one
/// that is `reach` off counts a quarter, one far off nothing. Joints stay within their limits.
///
/// Not shared between threads. The rig must outlive it.
class MarkerSolver {
 public:
  explicit MarkerSolver(const BodyRig& rig) : rig_{&rig}, solver_{rig} {}

  /// `seen`: a place for each marker, world, m; NaN where it is missing. From `start`, at most `max_steps`.
  /// No allocation, no throw.
  MarkerPose solve(std::span<const RigMarker> markers, std::span<const Vector3d> seen, const RigPose& start,
                   const PoseHold& hold, double reach, int max_steps);

  /// The same without knowing where to start: from several poses, by a reach that shrinks.
  MarkerPose search(std::span<const RigMarker> markers, std::span<const Vector3d> seen, const PoseHold& hold);

  /// H of the last step of solve() at its pose (1/rad^2, 1/m^2).
  const BodySolver::Matrix& information() const { return solver_.information(); }
  const BodySolver& problem() const { return solver_; }

 private:
  const BodyRig* rig_;
  BodySolver solver_;
};

/// The weight (1/m^2) of a marker that is `distance` off.
double markerWeight(double distance, double reach);

}  // namespace abstand::tracking
