// Other places for an arm or a leg, when the last one is no longer where it is seen.
#pragma once

#include <random>

#include "tracking/tracker/depth_fit.hpp"

namespace abstand::tracking {

/// An arm or a leg: three segments in a chain, of which the middle one bends on a hinge.
struct Limb {
  RigSegment upper, lower, end;
  double bend;  ///< +1: the lower segment bends towards x (elbow), -1: away (knee)
};
inline constexpr std::array<Limb, 4> kLimbs{{
    {RigSegment::kUpperArmLeft, RigSegment::kForearmLeft, RigSegment::kHandLeft, 1.0},
    {RigSegment::kUpperArmRight, RigSegment::kForearmRight, RigSegment::kHandRight, 1.0},
    {RigSegment::kThighLeft, RigSegment::kCalfLeft, RigSegment::kFootLeft, -1.0},
    {RigSegment::kThighRight, RigSegment::kCalfRight, RigSegment::kFootRight, -1.0},
}};

/// Puts the end joint (wrist, ankle) of a limb at `goal` (world), or as near as it reaches, its bend turned
/// by `swivel` (rad) about the line from shoulder to wrist, from where it points down (arm) or forward (leg).
void reachFor(const BodyRig& rig, const Limb& limb, const RigPlacement& X_WS, const Vector3d& goal,
              double swivel, RigPose& pose);

/// Tries places and keeps the best. Not shared between threads; no allocation, no throw.
class LimbSearch {
 public:
  explicit LimbSearch(DepthFit& fit) : fit_{&fit} {}

  /// `tries` random places about the wrist's own with standard deviation `spread` (m), and places of points
  /// that no segment explains. `pose` changes only when a place is better. Whether it did.
  bool search(const BodyObservation& seen, const Limb& limb, int tries, double spread,
              std::mt19937_64& random, RigPose& pose);

 private:
  double costOf(const BodyObservation& seen, const Limb& limb, const RigPose& pose, const RigPose& start);

  DepthFit* fit_;
  SeenPoints points_;  ///< a part of the image's
  std::array<float, SeenPoints::kMax> others_{}, scores_{};
  RigPlacement X_WS_;
};

}  // namespace abstand::tracking
