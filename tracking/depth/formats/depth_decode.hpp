// The fence around OpenCV's decoders of image files.
#pragma once

#include <string>

#include "tracking/depth/camera/depth_image.hpp"

namespace abstand::tracking {

/// An image of one channel of 16 bits, its header checked before, in metres (`scale`: units a metre). Throws
/// ParseError for one that is damaged; `kind` names it.
DepthImage decodeGrey16(const std::string& bytes, double scale, const std::string& file, const char* kind);

}  // namespace abstand::tracking
