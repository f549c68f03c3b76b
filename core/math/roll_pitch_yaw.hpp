// Fixed-axis angles of a rotation, as URDF and scene files have them, and numbers that people like to read.
#pragma once

#include "core/math/transform.hpp"

namespace abstand {

/// Roll, pitch, yaw (rad) with R = Rz(yaw) Ry(pitch) Rx(roll), also near a pitch of 90 degrees, where roll
/// and yaw are one: yaw is taken from what roll leaves of R.
Vector3d rollPitchYaw(const Matrix3d& R);

/// Short angles that give the same matrix to the bit: what a person wrote, as a rule. Where there are none,
/// the angles as computed.
Vector3d neatRollPitchYaw(const Matrix3d& R);

/// The decimal with the fewest digits within `tolerance` of the value; 0 where that is within it.
double neatNumber(double value, double tolerance);

}  // namespace abstand
