// Wrists beside the head.
#include "tracking/tracker/raised_arms.hpp"

#include "tracking/tracker/limb_search.hpp"

namespace abstand::tracking {

void raiseArms(const BodyRig& rig, double above, RigPose& pose, double aside) {
  RigPlacement X_WS;
  place(rig, pose, X_WS);
  for (std::size_t k = 0; k < 2; ++k) {
    const Limb& arm = kLimbs[k];
    const Vector3d out = (k == 0 ? 1.0 : -1.0) * X_WS[0].linear().col(1), up = X_WS[0].linear().col(2);
    const Vector3d shoulder = X_WS[index(rig[arm.upper].parent)] * rig[arm.upper].p_parent;
    reachFor(rig, arm, X_WS, shoulder + above * up + aside * out, 0.0, pose);
  }
}

}  // namespace abstand::tracking
