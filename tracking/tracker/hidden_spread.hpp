// Uncertainty of joints of occluded segments.
#pragma once

#include "tracking/body/body_rig.hpp"

namespace abstand::tracking {

/// Bit mask of the visible segments, by RigSegment.
using SeenSegments = std::uint32_t;

/// For each canonical joint the shortest path length (m) along the bones from a visible segment; 0 for a
/// joint of a visible segment, infinite if no segment is visible. Independent of joint angles: wherever the
/// limb is, the joint is within this distance of the end of the visible segment.
std::array<double, humanmodel::kJointCount> hiddenPathLengths(const BodyRig& rig, SeenSegments seen);

/// Converts the time since each segment was last visible into uncertainties. Estimate and truth are both
/// within hiddenPathLengths() of the visible segment, so at most twice that apart; in addition each part of
/// the person moves by at most kPersonSpeed since then. Does not allocate or throw.
class HiddenSpread {
 public:
  explicit HiddenSpread(const BodyRig& rig) : rig_{&rig} { last_seen_.fill(-kInfinity); }

  /// m, smallest standard deviation of a hidden joint, right after it was seen.
  static constexpr double kMin = 0.15;

  /// Records the visible segments of the image at `t` (s).
  void see(double t, SeenSegments seen);
  /// After see(): standard deviation (m) of each joint along its worst axis, such that kSpreadQuantile times
  /// it is the distance above; 0 for joints of visible segments. Without the error of the visible segment
  /// itself.
  const std::array<double, humanmodel::kJointCount>& spread() const { return spread_; }

 private:
  const BodyRig* rig_;
  std::array<double, kRigSegments> last_seen_;  ///< s; -infinity: never
  std::array<double, humanmodel::kJointCount> spread_{};
};

}  // namespace abstand::tracking
