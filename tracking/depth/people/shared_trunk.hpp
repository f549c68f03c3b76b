// Two peaks of one person, in plan view.
#pragma once

#include "tracking/depth/people/plan_view.hpp"

namespace abstand::tracking {

/// Whether two peaks at most kPeaksOfOne apart belong to one person, as both fists of raised arms do: what is
/// at the height of a trunk extends hardly farther than from one peak to the other, and hardly beyond both.
/// Of two people next to each other, each trunk extends beyond its head. People one behind the other, seen
/// from the camera, of whom only the fronts are visible, are always two. `top` (m): height of the lower peak.
/// Does not allocate or throw.
bool shareTrunk(const PlanView& plan, const PlanView::Place& a, const PlanView::Place& b, double top);

inline constexpr double kPeaksOfOne = 0.8;  ///< m

}  // namespace abstand::tracking
