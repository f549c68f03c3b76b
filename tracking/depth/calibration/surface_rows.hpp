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
  std::size_t rows{0};
  Vector3d middle{Vector3d::Zero()};  ///< m, mean of the points
  Matrix6d JTJ{Matrix6d::Zero()};
  Vector6d JTr{Vector6d::Zero()};
};

/// With Geman-McClure weights, whose scale follows from the median of the absolute distances, times the
/// weights of the rows.
SurfaceSum sumOf(const std::vector<SurfaceRow>& rows);

/// The damped Gauss-Newton step, so that an undetermined degree of freedom does not diverge; none if it is
/// not finite. Not for a sum without rows.
std::optional<Vector6d> stepOf(const SurfaceSum& sum);

}  // namespace abstand::tracking
