// Full orientations from directions: aim a frame, turn it about its bone, blend without flips.
#pragma once

#include <optional>

#include "core/math/transform.hpp"

namespace abstand::humanmodel {

/// Unit vector from a to b; nothing when they coincide. All vectors in one frame.
std::optional<Vector3d> directionFrom(const Vector3d& a, const Vector3d& b);

/// y axis (world) of the frame R_WP after the smallest rotation that takes its axis `a_P` to `b_W` (parallel
/// transport). Both are unit vectors and a_P is at right angles to P's y. Straight opposite: half a turn
/// about y.
Vector3d carriedY(const Matrix3d& R_WP, const Vector3d& a_P, const Vector3d& b_W);

/// Turns `y_W` about `b_W` towards the hinge axis `hinge_W`, which need not be a unit vector: its length is
/// the sine of the bend. Below 8 degrees of bend the hinge is noise and y stays; above 20 degrees y is the
/// hinge, between them part of the way. With `either_side` the hinge counts as a line, so that a joint that
/// passes through straight never turns its segment round by 180 degrees.
Vector3d turnedToHinge(const Vector3d& y_W, const Vector3d& b_W, const Vector3d& hinge_W, bool either_side);

/// The rotation R_WP whose a_P lies along b_W and whose y is nearest to `y_W`, orthonormal and right-handed.
/// a_P is at right angles to P's y; y_W is not along b_W.
Matrix3d frameAlong(const Vector3d& a_P, const Vector3d& b_W, const Vector3d& y_W);

}  // namespace abstand::humanmodel
