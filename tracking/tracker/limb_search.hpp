// Global search for an arm or a leg that is no longer where it was.
#pragma once

#include <random>
#include <span>

#include "tracking/tracker/depth_fit.hpp"

namespace abstand::tracking {

/// An arm or a leg: a chain of three segments, the middle one with a hinge.
struct Limb {
  RigSegment upper, lower, end;
  double bend;  ///< +1: the lower segment bends towards x (elbow), -1: away (knee)

  constexpr bool isArm() const { return bend > 0.0; }
};
inline constexpr std::array<Limb, 4> kLimbs{{
    {RigSegment::kUpperArmLeft, RigSegment::kForearmLeft, RigSegment::kHandLeft, 1.0},
    {RigSegment::kUpperArmRight, RigSegment::kForearmRight, RigSegment::kHandRight, 1.0},
    {RigSegment::kThighLeft, RigSegment::kCalfLeft, RigSegment::kFootLeft, -1.0},
    {RigSegment::kThighRight, RigSegment::kCalfRight, RigSegment::kFootRight, -1.0},
}};

/// The joint at which each of kLimbs is attached to the trunk, and those at the ends of its segments.
inline constexpr std::array<std::array<humanmodel::Joint, 4>, 4> kLimbJoints{{
    {humanmodel::Joint::kShoulderLeft, humanmodel::Joint::kElbowLeft, humanmodel::Joint::kWristLeft,
     humanmodel::Joint::kHandLeft},
    {humanmodel::Joint::kShoulderRight, humanmodel::Joint::kElbowRight, humanmodel::Joint::kWristRight,
     humanmodel::Joint::kHandRight},
    {humanmodel::Joint::kHipLeft, humanmodel::Joint::kKneeLeft, humanmodel::Joint::kAnkleLeft,
     humanmodel::Joint::kToeLeft},
    {humanmodel::Joint::kHipRight, humanmodel::Joint::kKneeRight, humanmodel::Joint::kAnkleRight,
     humanmodel::Joint::kToeRight},
}};

/// m, of the straight limb, without hand or foot.
inline double lengthOf(const BodyRig& rig, const Limb& limb) {
  return rig[limb.lower].p_parent.norm() + rig[limb.end].p_parent.norm();
}

/// Inverse kinematics: puts the end joint (wrist, ankle) of a limb at `goal` (world), or as near as possible,
/// with the elbow (knee) rotated by `swivel` (rad) about the line from shoulder to wrist, from pointing down
/// (arm) or forward (leg).
void reachFor(const BodyRig& rig, const Limb& limb, const RigPlacement& X_WS, const Vector3d& goal,
              double swivel, RigPose& pose);

/// A place that was tried.
struct LimbTry {
  double cost;           ///< m^2, LimbSearch::cost() of the pose, or less than that (LimbSearch::Scope::kept)
  Vector3d middle, end;  ///< m, world: elbow and wrist, knee and ankle
};

/// Tries positions and keeps the best. Not shared between threads; no allocation, no throw.
class LimbSearch {
 public:
  explicit LimbSearch(DepthFit& fit) : fit_{&fit} {}

  struct Scope {
    int tries;      ///< random positions
    double spread;  ///< m, their standard deviation around the wrist or ankle
    double kept;    ///< at least 1: of what was tried, costs up to this times the smallest one are exact
    bool recorded{true};  ///< what was tried becomes tries()
  };
  /// Of kLimbs[`limb`], tries random positions around the wrist, positions of points that no segment
  /// explains, and the straight limb that hangs, as a leg on which a person stands. Of an arm also the one
  /// that points away from a camera, as the trunk may hide it while it explains points of the other arm.
  /// `pose` changes only if one is better; returns whether it did.
  bool search(const BodyObservation& seen, std::size_t limb, const Scope& scope, std::mt19937_64& random,
              RigPose& pose);
  /// What the last recorded search for kLimbs[`limb`] tried, the place where it started included.
  std::span<const LimbTry> tries(std::size_t limb) const { return {tries_[limb].data(), tried_[limb]}; }
  /// Nothing was tried in this image.
  void forgetTries() { tried_.fill(0); }
  /// Cost (m^2) of kLimbs[`limb`] at a pose, as of what was tried.
  double cost(const BodyObservation& seen, std::size_t limb, const RigPose& pose);

 private:
  static constexpr std::size_t kMaxTries = 160;  ///< kept of each search

  void keep(std::size_t limb, double cost);
  void prepare(const BodyObservation& seen, const Limb& limb);
  double costOf(const BodyObservation& seen, const Limb& limb, const RigPose& pose, const RigPose& start,
                double limit = kInfinity);

  DepthFit* fit_;
  std::array<std::array<LimbTry, kMaxTries>, kLimbs.size()> tries_{};
  std::array<std::size_t, kLimbs.size()> tried_{};
  /// Points with their misfit to all segments but those of the limb.
  struct OtherwiseExplained {
    SeenPoints points;
    std::array<float, SeenPoints::kMax> others{};
  };
  double squares(const OtherwiseExplained& of, std::uint32_t segments);

  OtherwiseExplained all_;   ///< subset of the image's points
  OtherwiseExplained open_;  ///< those of them that only the limb can explain
  std::array<float, SeenPoints::kMax> scores_{};
  RigPlacement X_WS_;  ///< of the start, and of the limb at the last pose
};

}  // namespace abstand::tracking
