// Comparison of a person's facing directions, image by image.
#pragma once

#include <cstddef>

#include "tracking/tracker/facing.hpp"

namespace abstand::tracking {

/// Adds the costs of two bodies that follow the same person, one that faced the camera at first and one that
/// faced away: motion refutes the wrong one. One thread. Allocates nothing, does not throw.
class FacingTrial {
 public:
  /// Images that can decide; fewer, if the ratio of the costs is beyond kClear; and how many are compared.
  static constexpr std::size_t kMinImages = 30, kFewImages = 15, kMaxImages = 300;
  static constexpr double kClear = 1.5;
  /// Ratio of costs that are alike, so that noise does not turn the person in each image.
  static constexpr double kAlike = 1.01;
  static constexpr double kLikelyAwayAtFirst = 0.88;  ///< ratio, of fewer than kMinImages

  /// Costs (Misfit::cost) of an image.
  void add(double camera, double away);
  /// Facing away over facing the camera, of all images so far; NaN without images.
  double ratio() const;
  /// Whether facing away is the likelier direction; `away`: assumed so far, and kept if both are alike. Few
  /// images must show it clearly, as most people face the camera.
  bool isLikelyAway(bool away) const {
    if (images_ < kMinImages) return ratio() < kLikelyAwayAtFirst;
    return ratio() * (away ? 1.0 / kAlike : kAlike) < 1.0;
  }
  bool complete() const { return images_ >= kMaxImages; }
  /// If there are images enough, sets `facing.ratio`. The direction is decided if facing.decided() then.
  void judge(Facing& facing) const;

 private:
  std::size_t images_{0};
  double camera_{0.0}, away_{0.0};  ///< sums
};

}  // namespace abstand::tracking
