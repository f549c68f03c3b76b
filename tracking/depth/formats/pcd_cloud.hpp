// Point clouds of PCL, as a depth camera's grid of points.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/math/transform.hpp"
#include "tracking/depth/camera/depth_camera.hpp"

namespace abstand::tracking {

/// An organised cloud: a point for each pixel, row by row from the top.
struct PcdCloud {
  int width{0}, height{0};
  std::vector<Vector3f> points;  ///< m; NaN where nothing was measured
};

/// PCD of version 0.5 to 0.7: ascii, binary or binary_compressed, with the fields x, y, z (4 or 8 bytes of
/// floating point) among any others. Throws ParseError, also for a cloud of one row: it has lost which pixel
/// saw a point.
PcdCloud parsePcd(std::string_view bytes, const std::string& file);

/// The camera whose pixels look along the points: least squares of u z = fx x + cx z and v z = fy y + cy z
/// over `cloud`, with the median distance (pixels) between where points lie and where they should. Throws
/// ParseError where that is more than half a pixel or fewer than 100 points are there: the cloud was moved or
/// filtered.
struct FittedCamera {
  DepthCamera camera;
  double residual{0.0};  ///< pixels
};
FittedCamera fitCamera(const PcdCloud& cloud, const std::string& file);

}  // namespace abstand::tracking
