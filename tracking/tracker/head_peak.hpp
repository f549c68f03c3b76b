// The head of somebody who raises the hands above it.
#pragma once

#include <optional>

#include "tracking/tracker/body_observation.hpp"

namespace abstand::tracking {

/// z (m, world) of the vertex of a head that is lower than the highest points, as of somebody who raises a
/// hand: in the outline of a view, a local maximum as wide as a head, with shoulders or a trunk below.
/// nullopt if the highest points may be those of the head, or no head is seen. No allocation, no throw.
std::optional<double> headBelowHands(const BodyObservation& seen);

}  // namespace abstand::tracking
