// The base of the neck among several joints of a guessed neck.
#pragma once

#include <span>

#include "core/math/transform.hpp"
#include "tracking/recording/joint_map.hpp"

namespace abstand::tracking {

/// Moves the neck of a guess up towards the head where it lies too low. CMU's captures have a lower neck that
/// begins at the chest, 4 to 8 cm below the shoulders, and the base of the neck 10 cm above it; in other
/// skeletons the first joint of the neck is its base. The next joint on the way to the head is taken as long
/// as the neck is more than 0.1 of the trunk (pelvis to between the shoulders, in the rest pose) below the
/// shoulders, and the next one is nearer to 0.05 of the trunk above them. `parents` and `rest`: of the joints
/// of the file. Nothing happens without pelvis, shoulders, neck and head.
void raiseNeck(std::span<const int> parents, std::span<const Vector3d> rest, JointMatch& match);

}  // namespace abstand::tracking
