// Uncertainty of joints of occluded segments.
#pragma once

#include "tracking/body/joint_spread.hpp"

namespace abstand::tracking {

/// Bit mask of the visible segments, by RigSegment.
using SeenSegments = std::uint32_t;

inline bool isSeen(SeenSegments seen, RigSegment s) { return (seen >> index(s) & 1u) != 0; }

/// For each canonical joint the shortest path length (m) along the bones from a visible segment; 0 for a
/// joint of a visible segment, infinite if no segment is visible. Independent of joint angles: wherever the
/// limb is, the joint is within this distance of the end of the visible segment.
std::array<double, humanmodel::kJointCount> hiddenPathLengths(const BodyRig& rig, SeenSegments seen);

/// Uncertainty of hidden joints: the smallest of three bounds.
/// - Time: a joint moves by at most kPersonSpeed since its segment was last visible, when it was known to
/// kMin.
/// - Bones: estimate and truth are within hiddenPathLengths() of the visible segment, so at most twice that
///   apart.
/// - Free space: `extent` of HiddenSpace, with its shape.
/// Does not allocate or throw.
class HiddenSpread {
 public:
  explicit HiddenSpread(const BodyRig& rig) : rig_{&rig} {
    last_seen_.fill(-kInfinity);
    covariance_.fill(Matrix3d::Zero());
  }

  using Extents = std::array<double, humanmodel::kJointCount>;  ///< m, infinite: unknown
  /// m, smallest distance, right after a joint was seen: little of its segment was seen then.
  static constexpr double kMin = 0.25;

  /// Records the visible segments of the image at `t` (s).
  /// `shape`: of HiddenSpace; used where `extent` is the smallest bound and not below kMin.
  void see(double t, SeenSegments seen, const Extents& extent, const JointCovariances& shape);
  /// After see(): standard deviation (m) of each joint, such that kSpreadQuantile times it is the distance
  /// above; 0 for joints of visible segments. Without the error of the visible segment itself.
  const Extents& spread() const { return spread_; }
  /// Likewise the covariance (m^2, world): isotropic with that spread, or of the shape.
  const JointCovariances& covariance() const { return covariance_; }

 private:
  const BodyRig* rig_;
  std::array<double, kRigSegments> last_seen_;  ///< s; -infinity: never
  Extents spread_{};
  JointCovariances covariance_;
};

}  // namespace abstand::tracking
