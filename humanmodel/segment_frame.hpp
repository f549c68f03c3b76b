// Full orientations from directions: alignment, twist about the bone, blending without flips.
#pragma once

#include <optional>

#include "core/math/transform.hpp"

namespace abstand::humanmodel {

/// Unit vector from a to b; nullopt if they coincide. All vectors in one frame.
std::optional<Vector3d> directionFrom(const Vector3d& a, const Vector3d& b);

/// y axis (world) of the frame R_WP after the smallest rotation that maps its axis `a_P` to `b_W` (parallel
/// transport). Both are unit vectors and a_P is perpendicular to P's y. For opposite directions: half a turn
/// about y.
Vector3d carriedY(const Matrix3d& R_WP, const Vector3d& a_P, const Vector3d& b_W);

/// Rotates `y_W` about `b_W` towards the hinge axis `hinge_W`, whose length is the sine of the bend angle.
/// Below 8 degrees of bend the hinge is noise and y is unchanged; above 20 degrees y becomes the hinge; in
/// between it is blended. With `either_side` the sign of the hinge is ignored, so that a joint that passes
/// through straight never flips its segment by 180 degrees.
Vector3d turnedToHinge(const Vector3d& y_W, const Vector3d& b_W, const Vector3d& hinge_W, bool either_side);

/// The rotation R_WP that maps a_P to b_W and whose y is nearest to `y_W`, orthonormal and right-handed. a_P
/// is perpendicular to P's y; y_W is not parallel to b_W.
Matrix3d frameAlong(const Vector3d& a_P, const Vector3d& b_W, const Vector3d& y_W);

}  // namespace abstand::humanmodel
