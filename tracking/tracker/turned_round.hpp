// Front and back: the other way in which a person may stand in the same place.
#pragma once

#include "tracking/body/body_rig.hpp"

namespace abstand::tracking {

/// Where a person faces: rad, about the world's z from its x.
double yawOf(const RigPose& pose);

/// The pose of a person who faces the other way and whose limbs are where those of `pose` are: what was left
/// is right, and the feet point the other way. Joints whose limits forbid it come as near as they may. No
/// allocation, no throw.
RigPose flippedFacing(const BodyRig& rig, const RigPose& pose);

}  // namespace abstand::tracking
