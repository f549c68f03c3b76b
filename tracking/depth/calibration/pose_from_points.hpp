// Camera pose from points known in the camera frame and in the world.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tracking/depth/calibration/pose_spread.hpp"

namespace abstand::tracking {

struct MatchedPoint {
  Vector3d p_C, p_W;  ///< m: in the camera's optical frame, and in world
};

/// Reads a table: the header `cx,cy,cz,wx,wy,wz`, then one point on each line, m. Throws ParseError with line
/// and column.
std::vector<MatchedPoint> readMatchedPoints(const std::string& text, const std::string& file);

struct PoseFit {
  Transform X_WC;
  double rms{0.0};             ///< m, residual distances
  double worst{0.0};           ///< m
  std::size_t worst_point{0};  ///< counted from 0
  double sigma{0.0};  ///< m, of an axis of a point: squared residuals over the 3 n - 6 dof of n points
  Vector3d middle{Vector3d::Zero()};  ///< m, world: mean of the points
  Matrix6d covariance{
      Matrix6d::Identity()};  ///< of the steps of movedAbout() about it, for independent errors
  /// m, standard deviation along the worst axis of the origin of the camera's frame, and of points as far
  /// from the middle, 1 m at least: sigma and the covariance, by spreadWithin().
  double spread{0.0};
};

/// Least-squares rigid transform from camera points to world points (Kabsch 1976).
/// Throws UsageError for fewer than three points, or collinear points.
PoseFit fitPose(std::span<const MatchedPoint> points);

}  // namespace abstand::tracking
