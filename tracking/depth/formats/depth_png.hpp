// Depth images as 16-bit PNG.
#pragma once

#include <filesystem>

#include "tracking/depth/camera/depth_image.hpp"

namespace abstand::tracking {

/// Writes round(z * scale) as 16-bit grey; values out of range become 0, no measurement. Written completely
/// or not at all. Throws UsageError if the file cannot be written.
void saveDepthPng(const DepthImage& image, double scale, const std::filesystem::path& file);

/// Throws ParseError for anything except a PNG with one 16-bit channel, and for sides above
/// DepthCamera::kMaxPixels.
DepthImage loadDepthPng(const std::filesystem::path& file, double scale);

}  // namespace abstand::tracking
