// Rectifies images of a format or driver to those of an ideal pinhole camera.
#include "tracking/depth/camera/straight_images.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"

namespace abstand::tracking {
namespace {

constexpr float kMaxStraightDepth = 100.0f;  // m; beyond the range of depth cameras

/// For each pixel of an undistorted image, the row-major index of the nearest pixel in the distorted image;
/// -1 if outside.
std::vector<int> pixelsWithDistortion(const DepthCamera& c) {
  std::vector<int> from;
  from.reserve(static_cast<std::size_t>(c.width) * static_cast<std::size_t>(c.height));
  for (int v = 0; v < c.height; ++v) {
    for (int u = 0; u < c.width; ++u) {
      const Eigen::Vector2d with = c.pixelOf(c.at(u, v, 1.0));
      const double ud = std::round(with.x()), vd = std::round(with.y());
      const bool inside = ud >= 0.0 && vd >= 0.0 && ud < c.width && vd < c.height;
      from.push_back(inside ? static_cast<int>(vd) * c.width + static_cast<int>(ud) : -1);
    }
  }
  return from;
}

}  // namespace

StraightImages::StraightImages(const DepthCamera& camera, bool is_mirrored)
    : camera_(camera), is_mirrored_(is_mirrored) {
  if (!camera_.distortion.isZero(0.0)) {
    from_ = pixelsWithDistortion(camera_);
    straight_ = DepthImage(camera_.width, camera_.height);
    camera_.distortion.setZero();
  }
  if (is_mirrored_) camera_.cx = camera_.width - 1 - camera_.cx;
}

void StraightImages::straighten(DepthImage& image) {
  ABSTAND_CHECK(image.width == camera_.width && image.height == camera_.height);
  // The comparisons turn NaN into 0.
  for (float& z : image.z)
    if (!(z > 0.0f && z <= kMaxStraightDepth)) z = 0.0f;
  if (!from_.empty()) {
    for (std::size_t i = 0; i < from_.size(); ++i)
      straight_.z[i] = from_[i] >= 0 ? image.z[static_cast<std::size_t>(from_[i])] : 0.0f;
    image.z = straight_.z;
  }
  if (!is_mirrored_) return;
  for (int v = 0; v < camera_.height; ++v) std::reverse(&image.at(0, v), &image.at(0, v) + camera_.width);
}

}  // namespace abstand::tracking
