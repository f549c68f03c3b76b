// A camera with few pixels, for tests whose images are made by hand.
#pragma once

#include "tracking/depth/simulator/depth_render.hpp"

namespace abstand::tracking {

/// 160 x 120 pixels with the field of view of a Kinect.
inline DepthCamera smallCameraAt(const Vector3d& eye, const Vector3d& look) {
  DepthCamera camera;
  camera.width = 160;
  camera.height = 120;
  camera.fx = camera.fy = 145.0;
  camera.cx = 79.5;
  camera.cy = 59.5;
  camera.X_WC = lookingAt(eye, look);
  return camera;
}

/// 2.5 m ahead of the origin and 1 m high; looks level at it.
inline DepthCamera smallCamera() { return smallCameraAt({2.5, 0.0, 1.0}, {0.0, 0.0, 1.0}); }

}  // namespace abstand::tracking
