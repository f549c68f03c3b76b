// Gauss-Newton steps of a camera pose from distances between surfaces.
#pragma once

#include <optional>
#include <vector>

#include "tracking/depth/calibration/pose_spread.hpp"

namespace abstand::tracking {

/// A measured point and its distance from a surface.
struct SurfaceRow {
  double distance{0.0};            ///< m, signed, along n_W
  double weight{1.0};              ///< of the measurement, at most 1
  Vector3d p_W{Vector3d::Zero()};  ///< m
  Vector3d n_W{Vector3d::Zero()};  ///< derivative of the distance by a translation of the camera; unit vector
};

/// Residuals and normal equations of all rows for the steps of movedAbout() about `middle`.
struct SurfaceSum {
  double weights{0.0}, squares{0.0};
  double width{0.0};  ///< m, distance at which the weights of Geman-McClure are a fourth
  std::size_t rows{0};
  Vector3d middle{Vector3d::Zero()};  ///< m, mean of the points
  Matrix6d JTJ{Matrix6d::Zero()};
  Vector6d JTr{Vector6d::Zero()};
  /// Without the weights of Geman-McClure: sums of the rows' weights, of their normal matrices, and of the
  /// squares and the derivatives by the distance of the weighted distances. For covarianceOf().
  double all_weights{0.0}, influence_squares{0.0}, influence_slopes{0.0};
  Matrix6d all_JTJ{Matrix6d::Zero()};
};

/// With Geman-McClure weights, whose scale follows from the median of the absolute distances, times the
/// weights of the rows.
SurfaceSum sumOf(const std::vector<SurfaceRow>& rows);

/// Covariance of the pose by the steps of movedAbout() about `middle`, for independent errors of the rows.
/// Far distances have little weight, which costs accuracy: with the weighted distances psi of N rows it is
/// (sum psi^2 / (N - 6)) / (sum psi' / N)^2 (J^T J)^-1 (Huber 1981, chapter 7). Infinite if more than 6 rows
/// do not determine the pose.
Matrix6d covarianceOf(const SurfaceSum& sum);

/// The damped Gauss-Newton step, so that an undetermined degree of freedom does not diverge; none if it is
/// not finite. Not for a sum without rows.
std::optional<Vector6d> stepOf(const SurfaceSum& sum);

}  // namespace abstand::tracking
