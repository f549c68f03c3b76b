// How the legs of a body stand.
#pragma once

#include <cstddef>
#include <optional>

#include "tracking/body/body_rig.hpp"

namespace abstand::tracking {

inline constexpr double kAnkleHeight = 0.08;  ///< m, of somebody who stands

/// Whether a knee is on the floor z = 0. There is no chair then, thighs stand on the floor beside the hands,
/// and the toes point backwards.
bool kneels(const RigPlacement& X_WS);

/// Whether the head is below the pelvis and neither foot near the floor z = 0: people who bend stand.
bool isHeadlong(const RigPlacement& X_WS);

/// Whether the head is above the pelvis and both feet are higher above the floor than those of somebody who
/// stands, or sits on a chair: legs may explain what arms should.
bool floats(const RigPlacement& X_WS);
/// The pose with both ankles below the hips, on the floor as far as they reach. Does not allocate or throw.
RigPose standingLegs(const BodyRig& rig, const RigPose& pose, const RigPlacement& X_WS);

/// Of kLimbs, the leg whose ankle is well above the one of the other leg; nullopt if there is none. Of
/// somebody who is seen from the side, the far leg is hidden by the near one, and free to explain points of
/// the far arm.
std::optional<std::size_t> raisedLeg(const RigPlacement& X_WS);

/// The pose with the ankle of kLimbs[`leg`] on the floor below the hip, if the knee is bent and the ankle far
/// from there; otherwise nullopt. Does not allocate or throw.
std::optional<RigPose> plantedLeg(const BodyRig& rig, const RigPose& pose, const RigPlacement& X_WS,
                                  std::size_t leg);

/// The pose with kLimbs[`leg`] beside the other leg. `X_WS`: the placement of `pose`. Does not allocate or
/// throw.
RigPose loweredLeg(const BodyRig& rig, const RigPose& pose, const RigPlacement& X_WS, std::size_t leg);

}  // namespace abstand::tracking
