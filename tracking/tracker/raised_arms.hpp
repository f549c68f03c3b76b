// Initial poses of people with the hands at or above the head.
#pragma once

#include "tracking/body/body_rig.hpp"

namespace abstand::tracking {

/// Bends the arms so that the wrists are `above` (m) the shoulders, towards the head, and `aside` (m) of
/// them, outwards. No allocation, no throw.
void raiseArms(const BodyRig& rig, double above, RigPose& pose, double aside = 0.15);

}  // namespace abstand::tracking
