// Depth images as 16-bit TIFF.
#pragma once

#include <string>

#include "tracking/depth/camera/depth_image.hpp"

namespace abstand::tracking {

/// Width and height stated by the first image of a TIFF. Throws ParseError unless it has one upright channel
/// of 16-bit integers and sides up to DepthCamera::kMaxPixels, so that decoders do not allocate memory for
/// untrusted sizes.
struct TiffSize {
  int width{0}, height{0};
};
TiffSize checkDepthTiff(const std::string& bytes, const std::string& file);

/// Reads the first image, compressed or not (as supported by libtiff). Throws ParseError. `scale`: units per
/// metre.
DepthImage decodeDepthTiff(const std::string& bytes, double scale, const std::string& file);

}  // namespace abstand::tracking
