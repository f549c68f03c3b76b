// Visible surface of a body in plan view.
#pragma once

#include "tracking/depth/people/plan_view.hpp"

namespace abstand::tracking {

inline constexpr double kBodyRadius = 0.35;  ///< m, of a trunk around its head
inline constexpr double kMinBody = 0.05;     ///< m^2 of visible surface; less is no trunk

/// m^2, visible surface within `radius` (m) of a place.
double bodyArea(const PlanView& plan, const PlanView::Place& place, double radius);
/// Middle of the visible surface within kBodyRadius of a place, or the place if there is none.
PlanView::Place middleOfBody(const PlanView& plan, PlanView::Place place);

}  // namespace abstand::tracking
