// Shortest rotation from one direction to another.
#pragma once

#include "core/math/transform.hpp"

namespace abstand {

/// The rotation by the smallest angle that maps the direction of `from` to that of `to` (any lengths except
/// zero). For opposite directions, one of the half turns, always the same. The formula is that of Eigen's
/// setFromTwoVectors, but without its singular value decomposition for half turns, which is slow to compile.
Quaterniond turnBetween(const Vector3d& from, const Vector3d& to);

}  // namespace abstand
