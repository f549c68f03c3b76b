// Joints of the limbs in the frames of pelvis and chest.
#include "tracking/tracker/crossed_limbs.hpp"

#include "tracking/tracker/limb_search.hpp"

namespace abstand::tracking {
namespace {

constexpr double kCrossed = 0.05;  // m, that a joint is beyond the one of the other side

/// Whether both joints of the limbs are beyond those of the other side; `left`: unit vector, world.
bool crosses(const RigPlacement& X_WS, const Vector3d& left, const Limb& of_left, const Limb& of_right) {
  const auto is_beyond = [&](RigSegment a, RigSegment b) {
    return left.dot(X_WS[index(b)].translation() - X_WS[index(a)].translation()) > kCrossed;
  };
  return is_beyond(of_left.lower, of_right.lower) && is_beyond(of_left.end, of_right.end);
}

/// The pose with the ends of two limbs at each other's place.
RigPose exchanged(const BodyRig& rig, const RigPose& pose, const RigPlacement& X_WS, const Limb& a,
                  const Limb& b) {
  RigPose other = pose;
  reachFor(rig, a, X_WS, X_WS[index(b.end)].translation(), 0.0, other);
  reachFor(rig, b, X_WS, X_WS[index(a.end)].translation(), 0.0, other);
  return other;
}

}  // namespace

bool crossesLegs(const RigPlacement& X_WS) {
  return crosses(X_WS, X_WS[index(RigSegment::kPelvis)].linear().col(1), kLimbs[2], kLimbs[3]);
}

bool crossesArms(const RigPlacement& X_WS) {
  return crosses(X_WS, X_WS[index(RigSegment::kChest)].linear().col(1), kLimbs[0], kLimbs[1]);
}

RigPose uncrossedLegs(const BodyRig& rig, const RigPose& pose, const RigPlacement& X_WS) {
  return exchanged(rig, pose, X_WS, kLimbs[2], kLimbs[3]);
}

RigPose uncrossedArms(const BodyRig& rig, const RigPose& pose, const RigPlacement& X_WS) {
  return exchanged(rig, pose, X_WS, kLimbs[0], kLimbs[1]);
}

}  // namespace abstand::tracking
