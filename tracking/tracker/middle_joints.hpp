// Joints of a person of whom left and right may be exchanged.
#pragma once

#include <optional>

#include "humanmodel/joints.hpp"

namespace abstand::tracking {

/// Joints in the middle, and for each pair its middle in the place of both: the same for a body that faces
/// the other way. Tracked where both of a pair are, otherwise missing. States no covariance. No allocation.
humanmodel::SkeletonFrame middleJoints(const humanmodel::SkeletonFrame& frame);

/// m, world: from one body to another, median of the joints of trunk, head and legs, without those of the
/// arms, which are the first to be wrong. Of two results of middleJoints(). Nullopt if less than
/// kFewestMiddles are in both. No allocation.
std::optional<Vector3d> offsetBetween(const humanmodel::SkeletonFrame& from,
                                      const humanmodel::SkeletonFrame& to);

inline constexpr std::size_t kFewestMiddles = 4;

}  // namespace abstand::tracking
