// Images as they come from a format or a driver, made into those of a plain pinhole camera.
#pragma once

#include "tracking/depth/camera/depth_camera.hpp"
#include "tracking/depth/camera/depth_image.hpp"

namespace abstand::tracking {

/// Takes the distortion of a camera out of its images, by the nearest pixel, and turns those of a mirror
/// back. After the first image nothing allocates. One thread.
class StraightImages {
 public:
  /// `camera` is that of the images as they come.
  StraightImages(const DepthCamera& camera, bool is_mirrored);

  /// Of the images that straighten() leaves: without distortion.
  const DepthCamera& camera() const { return camera_; }
  /// Of the size of the camera. Depths that are no numbers, not above 0 or beyond 100 m become 0.
  void straighten(DepthImage& image);

 private:
  DepthCamera camera_;
  bool is_mirrored_;
  std::vector<int> from_;  ///< of a camera with distortion: the pixel that each one is taken from; -1: none
  DepthImage straight_;
};

}  // namespace abstand::tracking
