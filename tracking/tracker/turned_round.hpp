// Facing direction, and the pose with front and back exchanged.
#pragma once

#include "tracking/body/body_rig.hpp"

namespace abstand::tracking {

/// Facing direction of a pose: rad, about the world's z from its x.
double yawOf(const RigPose& pose);

/// Joints of a person facing the other way with the limbs in the same places: left and right are exchanged,
/// and the feet point the other way. No allocation, no throw.
humanmodel::SkeletonFrame flippedFacing(const humanmodel::SkeletonFrame& frame);

/// The pose of a person facing the other way with the limbs in the same places: left and right are exchanged,
/// and the feet point the other way. Joints limited otherwise get as near as possible. No allocation, no
/// throw.
RigPose flippedFacing(const BodyRig& rig, const RigPose& pose);

}  // namespace abstand::tracking
