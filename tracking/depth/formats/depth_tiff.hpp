// Depth images as TIFF of 16 bits.
#pragma once

#include <string>

#include "tracking/depth/camera/depth_image.hpp"

namespace abstand::tracking {

/// Width and height that the first image of a TIFF claims. Throws ParseError for what is no image of one
/// channel of 16 bits whole numbers, or has sides above DepthCamera::kMaxPixels, so that no decoder reserves
/// memory for what a stranger says.
struct TiffSize {
  int width{0}, height{0};
};
TiffSize checkDepthTiff(const std::string& bytes, const std::string& file);

/// Reads the first image, packed or not (whatever libtiff reads). Throws ParseError. `scale`: units a metre.
DepthImage decodeDepthTiff(const std::string& bytes, double scale, const std::string& file);

}  // namespace abstand::tracking
