// Depth image of the static surfaces in a recording.
#include "tracking/depth/calibration/still_image.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::tracking {
namespace {

/// m; four standard deviations of a Kinect, and its steps (kinect_noise.hpp).
float stillNoiseAt(float z) { return 0.01f + 0.01f * z * z; }

/// Depth of one pixel from its sorted depths (m) in `images` images; 0: not static.
float stillDepth(const std::vector<float>& sorted, std::size_t images) {
  if (sorted.empty() || 2 * sorted.size() < images) return 0.0f;
  const float median = sorted[sorted.size() / 2], noise = stillNoiseAt(median);
  double sum = 0.0;
  std::size_t agreeing = 0;
  for (const float z : sorted) {
    if (std::abs(z - median) > noise) continue;
    sum += static_cast<double>(z);
    ++agreeing;
  }
  if (static_cast<double>(agreeing) < kStillShare * static_cast<double>(sorted.size())) return 0.0f;
  return static_cast<float>(sum / static_cast<double>(agreeing));
}

}  // namespace

DepthImage stillImage(const std::vector<DepthImage>& images) {
  if (images.empty()) return {};
  DepthImage still(images.front().width, images.front().height);
  std::vector<float> depths;
  for (std::size_t i = 0; i < still.z.size(); ++i) {
    depths.clear();
    for (const DepthImage& image : images)
      if (image.z[i] > 0.0f) depths.push_back(image.z[i]);
    std::sort(depths.begin(), depths.end());
    still.z[i] = stillDepth(depths, images.size());
  }
  return still;
}

DepthImage stillImage(DepthStream& stream) {
  std::vector<DepthImage> images;
  const std::size_t count = std::min(kStillImages, stream.size());
  DepthFrame frame;
  for (std::size_t i = 0; i < count; ++i) {
    stream.seek(i * stream.size() / count);
    if (!stream.next(frame)) break;
    images.push_back(frame.image);
  }
  stream.seek(0);
  return stillImage(images);
}

}  // namespace abstand::tracking
