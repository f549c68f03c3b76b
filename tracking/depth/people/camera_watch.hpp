// Detects that a fixed depth camera was moved, or repeats an image.
#pragma once

#include "tracking/depth/camera/depth_image.hpp"
#include "tracking/depth/people/camera_motion.hpp"

namespace abstand::tracking {

/// Stores the depth of static surfaces on a coarse grid of pixels. The camera was moved if, for kLasts,
/// - a share of them has another depth in each third of the image (left, middle, right): people and robots do
///   not cover all three; or
/// - one rigid motion of the camera by kMoved or more explains what has changed on both sides
///   (CameraMotionFit), as of a camera that was turned sideways.
/// What has stood elsewhere for kSettlesAgain, as a chair, is static there. A motion that changes no depth,
/// as along a wall without edges, is not detected. Not shared between threads. see() does not throw, and does
/// not allocate after the first image.
class CameraWatch {
 public:
  explicit CameraWatch(const DepthCamera& camera);

  static constexpr double kLasts = 0.5;       ///< s
  static constexpr double kMovedShare = 0.2;  ///< of the static cells of a third
  static constexpr double kMoved = 0.04;      ///< m, of the surfaces in the image
  static constexpr int kSettlesAgain = 90;    ///< images

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
    float other{0.0f};          ///< m, of what is there instead of it
    int others{0};              ///< images in which that stood still
  };
  /// Of the static cells of each third.
  struct Counts {
    std::array<int, PixelGrid::kThirds> settled{}, differ{};
    bool haveMoved() const;
  };
  void learn(float z, Cell& cell) const;
  bool hasMoved(const Counts& counts);

  DepthCamera camera_;
  PixelGrid grid_;
  CameraMotionFit fit_;
  std::vector<Cell> cells_;
  std::vector<float> before_, now_;  // m, of the static cells; 0: not seen
  double differs_since_{kInfinity}, moved_at_{kInfinity};
  double last_t_{-kInfinity}, unchanged_since_{kInfinity};  ///< s
  std::size_t repeated_{0};
};

}  // namespace abstand::tracking
