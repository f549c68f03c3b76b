// Heads in plan view.
#pragma once

#include <vector>

#include "tracking/depth/people/plan_view.hpp"

namespace abstand::tracking {

inline constexpr double kHeadsApart = 0.28;  ///< m; of two heads that are nearer, the higher one counts

/// A head is a peak of a head's breadth with free space beside it, above enough of a body.
struct Head {
  int cell{-1};
  PlanView::Place place{PlanView::Place::Zero()};  ///< m
  double body{0.0};  ///< m^2 of surface below it, nearer to it than to other heads
  int shoulders{0};  ///< cells beside it that are lower by a head
};

/// m above the floor, of heads.
struct HeadHeights {
  double lowest, highest;
};
inline constexpr HeadHeights kHighHeads{0.9, 2.3};  ///< of people who stand, sit on a chair, or kneel
inline constexpr HeadHeights kLowHeads{0.6, 0.9};   ///< of people who sit on the floor

/// Sets `heads` to those of a plan, at most `max`. After plan.join(). Does not throw; allocates only if
/// `heads` has a smaller capacity than `max`.
void findHeads(const PlanView& plan, const HeadHeights& heights, std::size_t max, std::vector<Head>& heads);

}  // namespace abstand::tracking
