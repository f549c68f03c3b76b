// A hierarchy for points without one, from distances that stay the same.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tracking/joint_guess/shape_guess.hpp"

namespace abstand::tracking {

/// Joints of a person among points without a hierarchy, by shape, if their motion shows all twelve joints of
/// the limbs. Points whose distances to each other stay the same belong to one rigid body; bodies that share
/// a point are joined there. A body with at least three joints, such as the pelvis, gets a node in its
/// middle, from which its joints branch off. `names`, and the same number of points in all `frames`; at most
/// kMaxTreePoints points. Otherwise nothing is mapped, and the reason says why.
ShapeGuess guessByMotion(std::span<const std::string> names, std::span<const PointFrame> frames);

inline constexpr std::size_t kMaxTreePoints = 200;

}  // namespace abstand::tracking
