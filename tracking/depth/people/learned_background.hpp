// Background that is learned for each pixel.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "tracking/depth/camera/depth_image.hpp"

namespace abstand::tracking {

/// m; largest variation of a Kinect's depth of a static surface at depth `z` (m): steps of 2.9 mm z^2, twice.
inline float depthNoise(float z) { return 0.03f + 0.006f * z * z; }

/// For each pixel the farthest depth of an unassigned surface that was stable for a time. Not shared between
/// threads. Only the constructor allocates; nothing throws.
class LearnedBackground {
 public:
  /// `learn_after`: s, after which a static surface is background.
  LearnedBackground(std::size_t pixels, double learn_after);

  /// Whether a depth `z` (m) is that of the background: within four mean deviations (somewhat more than three
  /// standard deviations), or within the camera's own variation.
  bool has(std::size_t pixel, float z) const { return isStable(backgroundOf(pixel), z); }
  /// Whether an unassigned surface at depth `z` (m) has been stable for kSettled.
  bool hasSettled(std::size_t pixel, float z) const {
    return unassigned_[pixel].duration >= kSettled && isStable(unassigned_[pixel], z);
  }
  /// m; change of the mean depth of a settled surface, since it was stable for kReferenceAt.
  float drift(std::size_t pixel) const { return unassigned_[pixel].z - unassigned_[pixel].reference; }
  /// An unassigned surface at depth `z` (m), `dt` (s) after the last image.
  void learn(std::size_t pixel, float z, float dt) {
    constexpr float kNew = 0.1f;  // weight of the newest depth in the means
    StablePixel& surface = unassigned_[pixel];
    if (!isStable(surface, z)) {
      keepBackground(pixel);
      surface = {z, 0.5f * depthNoise(z), 0.0f, z};
      return;
    }
    surface.deviation += kNew * (std::abs(z - surface.z) - surface.deviation);
    surface.z += kNew * (z - surface.z);
    surface.duration += dt;
    if (surface.duration < kReferenceAt) surface.reference = surface.z;
  }
  /// A surface of a person: what was seen of an unassigned one is discarded, unless it is the background.
  void cover(std::size_t pixel) {
    keepBackground(pixel);
    unassigned_[pixel] = {};
  }
  /// Sets the background at once.
  void set(std::size_t pixel, float z);
  /// Whether most of the background beside the pixels with this label continues their depth: the surface was
  /// uncovered, it is nobody. `labels`: of all pixels, 0: of nobody.
  bool continues(std::span<const std::uint8_t> labels, std::uint8_t label, const DepthImage& image) const;

 private:
  /// Depth history of a pixel: mean depth (m; 0: none), mean absolute deviation (m), duration (s), and the
  /// mean depth at kReferenceAt.
  struct StablePixel {
    float z{0.0f}, deviation{0.0f}, duration{0.0f}, reference{0.0f};
  };
  bool isLearned(const StablePixel& surface) const { return surface.duration >= learn_after_; }
  const StablePixel& backgroundOf(std::size_t pixel) const {
    return isLearned(unassigned_[pixel]) ? unassigned_[pixel] : background_[pixel];
  }
  /// Before another surface is at the pixel.
  void keepBackground(std::size_t pixel) {
    if (isLearned(unassigned_[pixel])) background_[pixel] = unassigned_[pixel];
  }
  static bool isStable(const StablePixel& surface, float z) {
    const float varies = std::max(depthNoise(z), std::min(4.0f * surface.deviation, kMaxDeviation));
    return (surface.z > 0.0f) & (std::abs(z - surface.z) < varies);
  }

  static constexpr float kReferenceAt = 0.5f, kSettled = 0.7f;  ///< s
  static constexpr float kMaxDeviation = 0.3f;                  ///< m; surfaces that vary more are not static

  float learn_after_;
  std::vector<StablePixel> unassigned_;  ///< current unassigned surface; the background if isLearned()
  std::vector<StablePixel> background_;  ///< otherwise: the one learned before; z 0: none
};

}  // namespace abstand::tracking
