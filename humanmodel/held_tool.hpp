// A rigid tool in a hand: what the uncertainty of the hand means for it.
#pragma once

#include "humanmodel/human_model.hpp"

namespace abstand::humanmodel {

/// m: a b / sqrt(a^2 + b^2) with the two largest half extents of the bare hand (or any part).
double turnLever(const HumanPart& hand);

/// m: uncertainty of a rigid tool in a hand whose points are all within `hand` (m) of where they are shown.
/// `reach`: m, distance of the tool's farthest point from the hand's centre. `lever`: turnLever().
///
/// The hand's centre is within `hand`. A turn by the angle w about any axis moves an end of one of the two
/// longest axes by 2 sin(w / 2) `lever` at least, and both ends of an axis are within `hand`, so that
/// 2 sin(w / 2) <= min(hand / lever, 2). The tool's points are within hand + reach times that. Infinite if
/// `hand` is infinite. No throw.
double heldUncertainty(double hand, double reach, double lever) noexcept;

/// m: smallest half extent of the bare part.
double bareRadius(const HumanPart& part);

}  // namespace abstand::humanmodel
