// Detects that a fixed depth camera was moved, or repeats an image.
#pragma once

#include <span>
#include <vector>

#include "tracking/depth/camera/depth_camera.hpp"
#include "tracking/depth/camera/depth_image.hpp"

namespace abstand::tracking {

/// Stores the depth of static surfaces on a coarse grid of pixels. The camera was moved if, for kLasts, a
/// share of them has another depth in each third of the image (left, middle, right): people and robots do not
/// cover all three. A rotation in front of a wall that fills the image does not change the depths and is not
/// detected. Not shared between threads. see() does not throw, and does not allocate after the first image.
class CameraWatch {
 public:
  explicit CameraWatch(const DepthCamera& camera) : camera_{camera} {}

  static constexpr double kLasts = 0.5;       ///< s
  static constexpr double kMovedShare = 0.2;  ///< of the static cells of a third

  /// `t` (s) increases. `is_person`: for each pixel, not 0 for people. `known`: depths (m) of known objects,
  /// or null; pixels of both are ignored, except pixels of people near the floor: the floor seen by a moved
  /// camera may be assigned to them.
  void see(double t, const DepthImage& image, std::span<const std::uint8_t> is_person,
           const DepthImage* known = nullptr);

  /// s, first image after the camera was moved; infinite if it was not.
  double movedAt() const { return moved_at_; }
  /// Number of images equal to the previous one.
  std::size_t repeated() const { return repeated_; }
  /// s, of the first of the last images that are equal; infinite if the last two differ.
  double unchangedSince() const { return unchanged_since_; }

 private:
  struct Cell {
    float z{0.0f}, last{0.0f};  ///< m, of what stands still, and of the last image
    int images{0};              ///< in which it stood still
  };
  DepthCamera camera_;
  std::vector<Cell> cells_;
  double differs_since_{kInfinity}, moved_at_{kInfinity};
  double last_t_{-kInfinity}, unchanged_since_{kInfinity};  ///< s
  std::size_t repeated_{0};
};

}  // namespace abstand::tracking
