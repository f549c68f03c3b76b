// Legs and arms that a fit has exchanged.
#pragma once

#include "tracking/body/body_rig.hpp"

namespace abstand::tracking {

/// Whether the left knee and the left ankle are to the right of the other ones, seen from the pelvis: a fit
/// has put each leg on the other's place. People who cross their legs cross their thighs or their shins, not
/// both.
bool crossesLegs(const RigPlacement& X_WS);

/// The same of elbows and wrists, seen from the chest. Folded arms cross their forearms alone.
bool crossesArms(const RigPlacement& X_WS);

/// The pose with each ankle at the place of the other one, as far as the leg reaches, and the knee in front
/// of it. `X_WS`: the placement of `pose`. Does not allocate or throw.
RigPose uncrossedLegs(const BodyRig& rig, const RigPose& pose, const RigPlacement& X_WS);

/// Likewise with the wrists.
RigPose uncrossedArms(const BodyRig& rig, const RigPose& pose, const RigPlacement& X_WS);

}  // namespace abstand::tracking
