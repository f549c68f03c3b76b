// Roll, pitch, yaw of a rotation, as in URDF and scene files; numbers with few digits.
#pragma once

#include "core/math/transform.hpp"

namespace abstand {

/// Roll, pitch, yaw (rad) with R = Rz(yaw) Ry(pitch) Rx(roll). Near gimbal lock (pitch of 90 degrees) roll
/// and yaw are one angle: yaw is then computed from R with the roll removed.
Vector3d rollPitchYaw(const Matrix3d& R);

/// Angles with few digits that give exactly the same matrix, usually those that a person wrote. If there are
/// none, the angles as computed.
Vector3d neatRollPitchYaw(const Matrix3d& R);

/// The decimal with the fewest digits within `tolerance` of the value; 0 if that is within it.
double neatNumber(double value, double tolerance);

}  // namespace abstand
