// The joints of a person in a reading of a tree.
#pragma once

#include <span>
#include <string>

#include "tracking/joint_guess/shape_reading.hpp"
#include "tracking/recording/joint_map.hpp"

namespace abstand::tracking {

/// Joints of a reading with known sides, and their number. `poses` begins with the rest pose. A hand or a
/// foot on one side alone is taken only if it ends about where hands or feet do.
JointMatch jointsOf(const ShapeReading& r, bool leg_a_is_left, const SkeletonTree& tree,
                    std::span<const std::string> names, std::span<const Places> poses);

}  // namespace abstand::tracking
