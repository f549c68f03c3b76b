// The shortest turn from one direction to another.
#pragma once

#include "core/math/transform.hpp"

namespace abstand {

/// The rotation of the smallest angle that turns `from` onto `to` (any lengths but zero). Of the many half
/// turns between opposite directions one is taken, always the same. Out of line: Eigen's decides that
/// case by a singular value decomposition, which takes the compiler longer than the files that need the turn.
Quaterniond turnBetween(const Vector3d& from, const Vector3d& to);

}  // namespace abstand
