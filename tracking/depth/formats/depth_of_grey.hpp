// Depths from the values of a picture.
#pragma once

#include "tracking/depth/camera/depth_image.hpp"
#include "tracking/depth/formats/grey_pixels.hpp"

namespace abstand::tracking {

/// Depths in metres; `scale`: units per metre.
inline DepthImage depthOf(const GreyPixels& grey, double scale) {
  DepthImage image(grey.width, grey.height);
  for (std::size_t i = 0; i < image.z.size(); ++i) image.z[i] = static_cast<float>(grey.values[i] / scale);
  return image;
}

}  // namespace abstand::tracking
