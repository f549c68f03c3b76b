// Depth image of the static surfaces in a recording.
#pragma once

#include "tracking/depth/formats/depth_stream.hpp"

namespace abstand::tracking {

/// Static surfaces seen by a fixed camera: for each pixel, the mean of the depths (m) within the noise of
/// their median, from up to kStillImages images, evenly spread over the recording. 0 if fewer than half of
/// the images have a depth there, or fewer than kStillShare of these agree with the median, as where people
/// move. Throws ParseError.
DepthImage stillImage(DepthStream& stream);
DepthImage stillImage(const std::vector<DepthImage>& images);
inline constexpr std::size_t kStillImages = 40;
inline constexpr double kStillShare = 0.6;

}  // namespace abstand::tracking
