// Parts of an image that stand on the floor.
#pragma once

#include "tracking/tracker/body_view.hpp"

namespace abstand::tracking {

/// Marks as no_arm the points below kStandingBelow (m) under which there are points down to the floor z = 0
/// without a gap, such as those of legs of a person or of a chair. Only for a person whose hands do not reach
/// the floor. Does not allocate or throw.
void markStanding(SeenPoints& points);

inline constexpr float kStandingBelow = 0.55f;
inline constexpr float kNoArm = 0.3f;  ///< m, no_arm of marked points: more than any distance that explains

}  // namespace abstand::tracking
