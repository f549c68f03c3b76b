// Depth frames written by libfreenect's `record`.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tracking/depth/camera/depth_image.hpp"

namespace abstand::tracking {

/// Depth resolution of a Kinect v1 as delivered by its drivers.
inline constexpr int kKinectWidth = 640, kKinectHeight = 480;

/// Units of a dump. `record` writes the driver's buffer unchanged, with the low byte first, in violation of
/// PGM; other programs write the high byte first.
struct FreenectUnits {
  bool is_raw{true};  ///< 11-bit disparities, 2047: none; otherwise millimetres, 0: none
  bool is_low_first{true};
  std::string reason;
};

struct FreenectImage {
  DepthImage image;
  FreenectUnits units;
};

/// Depth (m) of a raw disparity: 1 / (3.3309495161 - 0.0030711016 raw), the line fitted for ROS's kinect_node
/// (OpenKinect wiki, "Imaging Information"; within 2 cm up to 2.5 m, 10 cm at 4 m); 0 for 2047 and for depths
/// that are not below 10 m.
float freenectDepth(int raw);
/// Inverse of freenectDepth(): the disparity nearest to `z` (m); 2047 if there is none. Depths are from 0.3
/// to 10 m.
int freenectRaw(float z);

/// A frame in the format of `record`: a PGM of disparities, the low byte first.
std::string freenectDump(const DepthImage& image);

/// Parses a PGM of type P5 with two bytes for each pixel. Units not given are detected from the image: values
/// up to 2047 with at least as many 2047 as 0 are disparities. Throws ParseError.
FreenectImage parseFreenectDepth(std::string_view bytes, const std::string& file,
                                 const std::optional<FreenectUnits>& units = {});

}  // namespace abstand::tracking
