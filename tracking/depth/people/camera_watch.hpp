// Notices that a fixed depth camera was moved, or repeats an image.
#pragma once

#include <span>
#include <vector>

#include "tracking/depth/camera/depth_camera.hpp"
#include "tracking/depth/camera/depth_image.hpp"

namespace abstand::tracking {

/// Keeps the depth of what stands still in a coarse grid of pixels. Moved: for kLasts some of that has
/// another depth in each third of the image, left, middle and right, as no person or robot hides or uncovers.
/// What turns about the view of a wall alone keeps its depths and is not noticed. Not shared between threads.
/// see() does not throw, and does not allocate after the first image.
class CameraWatch {
 public:
  explicit CameraWatch(const DepthCamera& camera) : camera_{camera} {}

  static constexpr double kLasts = 0.5;       ///< s
  static constexpr double kMovedShare = 0.2;  ///< of the cells of a third that stood still

  /// `t` (s) increases. `is_person`: for each pixel, not 0 for people. `known`: depths (m) of known objects,
  /// or null; neither is looked at. People are only looked at near the floor: a floor that a pushed camera
  /// sees nearer is taken for a part of them.
  void see(double t, const DepthImage& image, std::span<const std::uint8_t> is_person,
           const DepthImage* known = nullptr);

  /// s, first image after the camera was moved; infinite if it was not.
  double movedAt() const { return moved_at_; }
  /// Images that are equal to the one before them, as of a camera that hangs.
  std::size_t repeated() const { return repeated_; }

 private:
  struct Cell {
    float z{0.0f}, last{0.0f};  ///< m, of what stands still, and of the last image
    int images{0};              ///< in which it stood still
  };
  DepthCamera camera_;
  std::vector<Cell> cells_;
  double differs_since_{kInfinity}, moved_at_{kInfinity};
  std::size_t repeated_{0};
};

}  // namespace abstand::tracking
