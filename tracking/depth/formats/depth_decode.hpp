// Wraps OpenCV's image decoders.
#pragma once

#include <string>

#include "tracking/depth/camera/depth_image.hpp"

namespace abstand::tracking {

/// Decodes a single-channel 16-bit image, whose header was checked, to metres (`scale`: units per metre).
/// Throws ParseError for a damaged image; `kind` names it.
DepthImage decodeGrey16(const std::string& bytes, double scale, const std::string& file, const char* kind);

}  // namespace abstand::tracking
