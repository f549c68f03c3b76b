// Depth images as 16-bit PNG. The fence around OpenCV's image files.
#pragma once

#include <filesystem>

#include "tracking/depth/camera/depth_image.hpp"

namespace abstand::tracking {

/// Writes round(z * scale) in grey of 16 bits; what does not fit becomes 0, not measured. Whole or not at
/// all. Throws UsageError when the place cannot be written.
void saveDepthPng(const DepthImage& image, double scale, const std::filesystem::path& file);

/// Throws ParseError for what is no PNG of one channel of 16 bits, and for sides above
/// DepthCamera::kMaxPixels.
DepthImage loadDepthPng(const std::filesystem::path& file, double scale);

}  // namespace abstand::tracking
