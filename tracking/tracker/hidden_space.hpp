// Space that is free for hidden limbs.
#pragma once

#include "tracking/tracker/body_observation.hpp"
#include "tracking/tracker/hidden_spread.hpp"
#include "tracking/tracker/limb_search.hpp"

namespace abstand::tracking {

/// Where the joints of hidden limbs can be. Poses of each hidden chain, from the joint at which it is
/// attached to a visible segment, are sampled evenly over the directions that the joint limits allow; samples
/// of which a joint or the middle of a bone lies where a camera sees past (not behind what it sees), before
/// what it sees, or below the floor z = 0 are refuted. Not shared between threads; update() does not allocate
/// or throw.
class HiddenSpace {
 public:
  explicit HiddenSpace(const BodyRig& rig);

  static constexpr int kSamples = 128;  ///< of each chain
  static constexpr double kShare = 0.97;
  /// m; less than this outside of what was seen refutes nothing: error of the chain's attachment.
  static constexpr double kTolerance = 0.05;

  void update(const BodyObservation& seen, const RigPlacement& X_WS, SeenSegments visible);
  /// m, for each joint: kShare of the samples that are not refuted are nearer to the joint in the pose than
  /// this. Infinite for joints of visible segments, of the trunk and the head, and of chains of which fewer
  /// than kFewest samples are left.
  const std::array<double, humanmodel::kJointCount>& extent() const { return extent_; }

  static constexpr int kFewest = 8;

 private:
  static bool isFree(const BodyObservation& seen, const Vector3d& p_W);
  void sample(const BodyObservation& seen, const RigPlacement& X_WS, SeenSegments visible, const Limb& limb);

  const BodyRig* rig_;
  std::array<std::array<Vector3d, kSamples>, 3> direction_;  ///< unit vectors, for each link of a chain
  std::array<std::array<double, kSamples>, 3> distance_{};   ///< m, of the samples left, by link
  std::array<double, humanmodel::kJointCount> extent_{};
};

}  // namespace abstand::tracking
