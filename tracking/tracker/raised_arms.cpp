// Wrists beside the head, or beside the hips.
#include "tracking/tracker/raised_arms.hpp"

namespace abstand::tracking {

void raiseArms(const BodyRig& rig, double above, RigPose& pose, double aside, std::array<bool, 2> which) {
  RigPlacement X_WS;
  place(rig, pose, X_WS);
  for (std::size_t k = 0; k < 2; ++k) {
    if (!which[k]) continue;
    const Limb& arm = kLimbs[k];
    const Vector3d out = (k == 0 ? 1.0 : -1.0) * X_WS[0].linear().col(1), up = X_WS[0].linear().col(2);
    const Vector3d shoulder = X_WS[index(rig[arm.upper].parent)] * rig[arm.upper].p_parent;
    reachFor(rig, arm, X_WS, shoulder + above * up + aside * out, 0.0, pose);
  }
}

bool isRaised(const RigPlacement& X_WS, const Limb& arm) {
  return X_WS[index(arm.lower)].translation().z() > X_WS[index(arm.upper)].translation().z();
}

RigPose hangingArm(const BodyRig& rig, const RigPose& pose, const RigPlacement& X_WS, const Limb& arm) {
  constexpr double kStretched = 0.97;  // of the length of the arm, as the elbows of hanging arms are bent
  const double length = kStretched * lengthOf(rig, arm);
  const Vector3d shoulder = X_WS[index(arm.upper)].translation();
  RigPose hanging = pose;
  reachFor(rig, arm, X_WS, shoulder - length * X_WS[index(rig[arm.upper].parent)].linear().col(2), 0.0,
           hanging);
  return hanging;
}

}  // namespace abstand::tracking
