// Static surfaces in a depth image as points with normals.
#pragma once

#include <vector>

#include "tracking/depth/camera/depth_camera.hpp"
#include "tracking/depth/camera/depth_image.hpp"

namespace abstand::tracking {

/// A measured point on a smooth surface.
struct RoomPoint {
  Vector3d p_C{Vector3d::Zero()};  ///< m
  Vector3d n_C{Vector3d::Zero()};  ///< unit, towards the camera; zero: not smooth or not measured
  bool smooth() const { return !n_C.isZero(0.0); }
};

/// Points on a grid of at most kColumns columns, with normals from planes fitted to the surrounding pixels.
class RoomView {
 public:
  static constexpr int kColumns = 320;

  /// `camera` without distortion.
  RoomView(const DepthCamera& camera, const DepthImage& image);

  const DepthCamera& camera() const { return camera_; }
  /// All smooth points.
  const std::vector<RoomPoint>& points() const { return points_; }
  /// Mean of points() (m); zero without any.
  Vector3d middle() const;
  /// Width of a pixel of the grid at the depth of 1 m (m).
  double pixel() const { return step_ / camera_.fx; }
  /// The grid point at the pixel of a point in the camera's frame; null outside the image and where nothing
  /// was measured. It may be not smooth.
  const RoomPoint* at(const Vector3d& p_C) const;

 private:
  RoomPoint pointAt(const DepthImage& image, int u, int v) const;

  DepthCamera camera_;
  int step_{1}, columns_{0}, rows_{0};
  std::vector<RoomPoint> grid_, points_;
};

}  // namespace abstand::tracking
