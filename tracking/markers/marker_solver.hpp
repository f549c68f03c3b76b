// Solves one pose of a rig from one moment of markers.
#pragma once

#include <optional>
#include <span>

#include "tracking/body/body_solver.hpp"

namespace abstand::tracking {

/// A marker fixed to a segment, at p_S (m).
struct RigMarker {
  RigSegment segment{RigSegment::kPelvis};
  Vector3d p_S{Vector3d::Zero()};
};

/// m, soft tissue artefact: standard deviation of a correctly placed marker.
inline constexpr double kSkinMotion = 0.010;
/// m; a marker farther than this from its position on the body is misplaced: swapped, a ghost, or fallen off.
inline constexpr double kMisplaced = 0.060;

/// Regularisation of a pose where markers do not determine it.
struct PoseHold {
  std::optional<RigPose> last;  ///< previous pose
  double turn{0.0};             ///< rad, m: standard deviation of the change of a dof since then
  BodySolver::Vector to_rest{BodySolver::Vector::Zero()};  ///< 1/rad^2, towards standing
};

struct MarkerPose {
  RigPose pose;
  double cost{0.0};  ///< robust misfit of the markers; without limits and hold
  double rms{0.0};   ///< m, over the markers that are not misplaced; infinite if there are none
  int seen{0}, misplaced{0};
};

/// Least squares over the visible markers, by Gauss-Newton with Geman-McClure weights: a marker at the
/// distance `reach` has a weight of 1/4, a far one 0. Joints stay within their limits.
///
/// Not shared between threads. The rig must outlive this object.
class MarkerSolver {
 public:
  explicit MarkerSolver(const BodyRig& rig) : rig_{&rig}, solver_{rig} {}

  /// `seen`: a position for each marker, world, m; NaN if missing. Starts from `start`, at most `max_steps`.
  /// No allocation, no throw.
  MarkerPose solve(std::span<const RigMarker> markers, std::span<const Vector3d> seen, const RigPose& start,
                   const PoseHold& hold, double reach, int max_steps);

  /// The same without a start pose: from several poses, with a decreasing `reach`.
  MarkerPose search(std::span<const RigMarker> markers, std::span<const Vector3d> seen, const PoseHold& hold);

  /// H of the last step of solve() at its pose (1/rad^2, 1/m^2).
  const BodySolver::Matrix& information() const { return solver_.information(); }
  const BodySolver& problem() const { return solver_; }

 private:
  const BodyRig* rig_;
  BodySolver solver_;
};

/// Weight (1/m^2) of a marker at `distance` (m).
double markerWeight(double distance, double reach);

}  // namespace abstand::tracking
