// Knees and ankles in the frame of the pelvis.
#include "tracking/tracker/crossed_legs.hpp"

#include "tracking/tracker/limb_search.hpp"

namespace abstand::tracking {
namespace {

using enum RigSegment;

constexpr double kCrossed = 0.05;  // m, that a joint is beyond the one of the other side

}  // namespace

bool crossesLegs(const RigPlacement& X_WS) {
  const Vector3d left = X_WS[index(kPelvis)].linear().col(1);
  const auto is_beyond = [&](RigSegment of_left, RigSegment of_right) {
    return left.dot(X_WS[index(of_right)].translation() - X_WS[index(of_left)].translation()) > kCrossed;
  };
  return is_beyond(kCalfLeft, kCalfRight) && is_beyond(kFootLeft, kFootRight);
}

RigPose uncrossedLegs(const BodyRig& rig, const RigPose& pose, const RigPlacement& X_WS) {
  RigPose other = pose;
  reachFor(rig, kLimbs[2], X_WS, X_WS[index(kFootRight)].translation(), 0.0, other);
  reachFor(rig, kLimbs[3], X_WS, X_WS[index(kFootLeft)].translation(), 0.0, other);
  return other;
}

}  // namespace abstand::tracking
