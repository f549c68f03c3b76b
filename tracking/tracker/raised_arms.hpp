// Poses of people with the hands at or above the head, or not.
#pragma once

#include <array>

#include "tracking/tracker/limb_search.hpp"

namespace abstand::tracking {

inline constexpr double kRaisedAside = 0.15;  ///< m, of a wrist beside the head, from the shoulder

/// Bends the arms so that the wrists are `above` (m) the shoulders, towards the head, and `aside` (m) of
/// them, outwards; `which`: left, right. No allocation, no throw.
void raiseArms(const BodyRig& rig, double above, RigPose& pose, double aside = kRaisedAside,
               std::array<bool, 2> which = {true, true});

/// Whether the elbow is above the shoulder.
bool isRaised(const RigPlacement& X_WS, const Limb& arm);

/// The pose with an arm along the trunk. `X_WS`: the placement of `pose`. No allocation, no throw.
RigPose hangingArm(const BodyRig& rig, const RigPose& pose, const RigPlacement& X_WS, const Limb& arm);

}  // namespace abstand::tracking
