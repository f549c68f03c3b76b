// What a person sits on.
#pragma once

#include "tracking/body/body_rig.hpp"
#include "tracking/tracker/body_view.hpp"

namespace abstand::tracking {

/// Whether the person sits on a seat: hips and knees at about the same height, the calves upright. Not on the
/// floor, and not on the knees.
bool sitsOnSeat(const BodyRig& rig, const RigPlacement& X_WS);

/// Moves points from `points` to the end of `seat` that lie below the thighs of a person who sits, not ahead
/// of the knees, within kHalfSeat, and beside calves and feet: the edge and the legs of the seat, which would
/// pull the thighs down. No part of a person is there, unless the calves of the pose are misplaced. Points
/// keep their order; those for which `seat` has no room are lost. Returns how many were moved. Does not
/// allocate or throw.
std::size_t moveSeatPoints(const BodyRig& rig, const RigPlacement& X_WS, SeenPoints& points,
                           SeenPoints& seat);

/// m below the knees, the radius of a thigh there: lower points belong to no thigh that is level.
inline constexpr double kUnderThighs = 0.06;
/// m from the middle of a calf or a foot: twice their radius.
inline constexpr double kBesideCalf = 0.12;
/// m to each side of the hips: half the breadth of an office chair's seat, and its arm rests.
inline constexpr double kHalfSeat = 0.35;

}  // namespace abstand::tracking
