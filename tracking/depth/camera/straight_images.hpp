// Rectifies images of a format or driver to those of an ideal pinhole camera.
#pragma once

#include "tracking/depth/camera/depth_camera.hpp"
#include "tracking/depth/camera/depth_image.hpp"

namespace abstand::tracking {

/// Removes lens distortion by nearest-pixel remapping, and mirroring. No allocation after the first image.
/// One thread.
class StraightImages {
 public:
  /// `camera`: that of the original images.
  StraightImages(const DepthCamera& camera, bool is_mirrored);

  /// The camera of the rectified images, without distortion.
  const DepthCamera& camera() const { return camera_; }
  /// `image` has the size of the camera. Depths that are NaN, <= 0 or above 100 m become 0.
  void straighten(DepthImage& image);

 private:
  DepthCamera camera_;
  bool is_mirrored_;
  std::vector<int> from_;  ///< for a camera with distortion: source pixel of each pixel; -1: none
  DepthImage straight_;
};

}  // namespace abstand::tracking
