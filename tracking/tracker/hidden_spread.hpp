// How well the joints of segments are known that the camera does not see.
#pragma once

#include "tracking/body/body_rig.hpp"

namespace abstand::tracking {

/// The segments that were seen, bit by RigSegment.
using SeenSegments = std::uint32_t;

/// For each canonical joint the shortest way (m) along the bones from a seen segment to it; 0 for a joint of
/// a seen segment, infinite where no segment is seen. Joint angles do not matter: wherever the limb is, the
/// joint is within this distance of the end of the seen segment.
std::array<double, humanmodel::kJointCount> hiddenWays(const BodyRig& rig, SeenSegments seen);

/// Remembers when each segment was last seen, and turns that into uncertainties. Estimate and truth both lie
/// within hiddenWays() of the seen segment, so at most twice that apart; and since the segment was last seen,
/// each part of the person has moved by kPersonSpeed at most. Does not allocate, does not throw.
class HiddenSpread {
 public:
  explicit HiddenSpread(const BodyRig& rig) : rig_{&rig} { last_seen_.fill(-kInfinity); }

  /// m, standard deviation of a hidden joint that was seen a moment ago; the least that is ever said of one.
  static constexpr double kMin = 0.15;

  /// The image at `t` (s) shows these segments.
  void see(double t, SeenSegments seen);
  /// After see(): standard deviation (m) of each joint along its worst axis, so that kSpreadQuantile times it
  /// is the distance above; 0 for joints of seen segments. Without the error of the seen segment itself.
  const std::array<double, humanmodel::kJointCount>& spread() const { return spread_; }

 private:
  const BodyRig* rig_;
  std::array<double, kRigSegments> last_seen_;  ///< s; -infinity: never
  std::array<double, humanmodel::kJointCount> spread_{};
};

}  // namespace abstand::tracking
