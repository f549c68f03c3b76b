// Facing direction, and the pose with front and back exchanged.
#pragma once

#include "tracking/body/body_rig.hpp"

namespace abstand::tracking {

/// Solver steps that move a body which was turned round in place to where it explains the image.
inline constexpr int kTurnSteps = 15;

/// Facing direction of a pose: rad, about the world's z from its x.
double yawOf(const RigPose& pose);

/// Whether two poses face ways less than 60 degrees apart.
bool faceAlike(const RigPose& a, const RigPose& b);

/// Whether this is the front of a person who lies on the back or on the front.
bool facesUpOrDown(const Vector3d& front);

/// The joint on the other side; joints in the middle are their own.
humanmodel::Joint mirrored(humanmodel::Joint joint);

/// Joints of a person facing the other way with the limbs in the same places: left and right are exchanged,
/// and the feet point the other way; of a person who lies, to the other side of the trunk. No allocation, no
/// throw.
humanmodel::SkeletonFrame flippedFacing(const humanmodel::SkeletonFrame& frame);

/// The pose of a person facing the other way with the limbs in the same places: left and right are exchanged,
/// and the feet point the other way. Joints limited otherwise get as near as possible. No allocation, no
/// throw.
RigPose flippedFacing(const BodyRig& rig, const RigPose& pose);

}  // namespace abstand::tracking
