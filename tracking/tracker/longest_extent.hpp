// The direction in which points extend farthest.
#pragma once

#include "tracking/tracker/body_view.hpp"

namespace abstand::tracking {

/// rad, of the longest horizontal extent of the points about `middle` (m, world), up to a half turn.
double longestExtent(const SeenPoints& points, const Vector3d& middle);

}  // namespace abstand::tracking
