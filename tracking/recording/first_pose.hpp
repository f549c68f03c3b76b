// T-poses that converters put before a movement.
#pragma once

#include <optional>
#include <span>

#include "humanmodel/joints.hpp"

namespace abstand::tracking {

/// If the first frame is a T-pose that the second does not continue: the angle (rad) by which the arm that
/// turns more differs in the second frame. A T-pose has both arms straight and level (within 25 degrees)
/// along the line of the shoulders, and both legs within 25 degrees of it downwards; not continued is an arm
/// that turns by more than 20 degrees. z up. nullopt for fewer than two frames, other poses, and missing
/// joints.
std::optional<double> leadingTPose(std::span<const humanmodel::SkeletonFrame> frames);

}  // namespace abstand::tracking
