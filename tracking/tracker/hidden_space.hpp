// Space that is free for hidden limbs.
#pragma once

#include "tracking/tracker/body_observation.hpp"
#include "tracking/tracker/hidden_spread.hpp"
#include "tracking/tracker/limb_search.hpp"

namespace abstand::tracking {

/// Region in which the joints of hidden limbs can be. Poses of each hidden chain, starting at the joint that
/// attaches it to a visible segment, are sampled uniformly over the directions within the joint limits. A
/// sample is rejected if a joint or the middle of a bone is in space that a camera observes to be empty, in
/// front of a measured surface, or below the floor z = 0. Not shared between threads; update() does not
/// allocate or throw.
class HiddenSpace {
 public:
  explicit HiddenSpace(const BodyRig& rig);

  static constexpr int kSamples = 128;  ///< of each chain
  static constexpr double kShare = 0.97;
  /// m; samples less than this inside empty space are kept: error of the joint that attaches the chain.
  static constexpr double kTolerance = 0.05;

  void update(const BodyObservation& seen, const RigPlacement& X_WS, SeenSegments visible);
  /// m, for each joint: quantile kShare of the distances between the joint in the fitted pose and in the
  /// samples that are not rejected. Infinite for joints of visible segments, trunk and head, and of chains
  /// with fewer than kFewest such samples.
  const std::array<double, humanmodel::kJointCount>& extent() const { return extent_; }

  /// m^2, world: ellipsoid about the fitted joint, all e with e . S^-1 e <= 1. S is proportional to a power
  /// from 0.25 to 1 of the second moments of the samples about the joint, and holds all of them; or it is the
  /// ball of the extent: the one with the smallest sum of semi-axes. None is shorter than kThin. Zero without
  /// an extent.
  const JointCovariances& shape() const { return shape_; }

  static constexpr int kFewest = 8;
  /// m, shortest semi-axis: the free space is known to the cells of the observation.
  static constexpr double kThin = 0.12;

 private:
  static bool isFree(const BodyObservation& seen, const Vector3d& p_W);
  double shareOf(std::size_t count);
  Matrix3d shapeOf(std::size_t link, std::size_t count, double extent) const;
  void sample(const BodyObservation& seen, const RigPlacement& X_WS, SeenSegments visible, const Limb& limb);

  const BodyRig* rig_;
  std::array<std::array<Vector3d, kSamples>, 3> direction_;  ///< unit vectors, for each link of a chain
  std::array<std::array<Vector3d, kSamples>, 3> offset_;     ///< m, of the samples left, by link
  std::array<double, kSamples> distance_{};
  std::array<double, humanmodel::kJointCount> extent_{};
  JointCovariances shape_;
};

}  // namespace abstand::tracking
