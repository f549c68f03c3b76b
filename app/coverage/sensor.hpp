// Depth cameras that a plan may choose from.
#pragma once

#include <string>
#include <vector>

#include "tracking/depth/camera/depth_camera.hpp"

namespace abstand::coverage {

/// Lens, image size, pose and range of a depth camera.
struct Sensor {
  tracking::DepthCamera camera;        ///< without distortion
  double nearest{0.5}, farthest{8.0};  ///< m along the optical axis; no measurement outside of this range
};

/// Names that sensorNamed() knows; the first one is the default.
std::vector<std::string> sensorNames();

/// `kinect`: a Kinect v1 as rendered by `render-depth`, 640 x 480, f = 580 pixels, with the range of
/// KinectNoise. `kinect_v2`: 512 x 424, f = 365.5 pixels as in depth recordings without a camera file, 0.5 to
/// 4.5 m (Microsoft, Kinect for Windows v2 Human Interface Guidelines). At the origin. Throws UsageError for
/// another name.
Sensor sensorNamed(const std::string& name);

/// Lens, image size and pose of a camera file, with the range of a Kinect v1. The distortion is left out:
/// depth images are straightened when they are read. Throws ParseError.
Sensor sensorOfFile(const std::filesystem::path& file);

/// The same field of view in an image of `columns`; unchanged if the image has no more. The rows are rounded.
tracking::DepthCamera reduced(const tracking::DepthCamera& camera, int columns);

}  // namespace abstand::coverage
