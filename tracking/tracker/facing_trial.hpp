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

  /// Costs (Misfit::cost) of an image.
  void add(double camera, double away);
  /// Facing away over facing the camera, of all images so far; NaN without images.
  double ratio() const;
  /// Whether facing away is so much better that it is assumed while undecided.
  bool isLikelyAway() const { return ratio() < Facing::kLikelyAway; }
  bool complete() const { return images_ >= kMaxImages; }
  /// If there are images enough, sets `facing.ratio`. The direction is decided if facing.decided() then.
  void judge(Facing& facing) const;

 private:
  std::size_t images_{0};
  double camera_{0.0}, away_{0.0};  ///< sums
};

}  // namespace abstand::tracking
