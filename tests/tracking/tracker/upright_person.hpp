// A body in a posture that tests know in closed form.
#pragma once

#include "tracking/body/body_rig.hpp"

namespace abstand::tracking {

/// A person who stands upright with hanging arms, the pelvis 0.95 m above `moved` (m, world).
inline RigPlacement uprightAt(const BodyRig& rig, const Vector3d& moved) {
  RigPose pose;
  pose.X_WP.translation() = moved + Vector3d(0.0, 0.0, 0.95);
  RigPlacement X_WS;
  place(rig, pose, X_WS);
  return X_WS;
}

}  // namespace abstand::tracking
