// Wraps libtiff: pictures in memory.
#pragma once

#include <optional>
#include <string>

#include "tracking/depth/formats/grey_pixels.hpp"

namespace abstand::tracking {

/// Decodes the first picture of a TIFF with one channel of 16 bits, whose directory was checked
/// (depth_tiff.hpp). Empty for a damaged picture, and for one that is not stored from its top left.
std::optional<GreyPixels> decodedTiff(const std::string& bytes);

}  // namespace abstand::tracking
