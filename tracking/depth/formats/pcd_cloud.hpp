// Organised point clouds of PCL, as images of a depth camera.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/math/transform.hpp"
#include "tracking/depth/camera/depth_camera.hpp"

namespace abstand::tracking {

/// An organised cloud: one point for each pixel, row by row from the top.
struct PcdCloud {
  int width{0}, height{0};
  std::vector<Vector3f> points;  ///< m; NaN without measurement
};

/// Parses PCD versions 0.5 to 0.7: ascii, binary or binary_compressed, with the fields x, y, z (4 or 8 bytes
/// of floating point) among others. Throws ParseError, also for a cloud of one row, which has no pixel grid.
PcdCloud parsePcd(std::string_view bytes, const std::string& file);

/// Fits the camera whose pixel rays contain the points: least squares of u z = fx x + cx z and v z = fy y +
/// cy z over `cloud`, with the median reprojection error (pixels). Throws ParseError if that is more than
/// half a pixel or there are fewer than 100 points: the cloud was transformed or filtered.
struct FittedCamera {
  DepthCamera camera;
  double residual{0.0};  ///< pixels
};
FittedCamera fitCamera(const PcdCloud& cloud, const std::string& file);

}  // namespace abstand::tracking
