// Which person a part of the plan view belongs to.
#pragma once

#include <optional>

#include "tracking/depth/people/plan_view.hpp"

namespace abstand::tracking {

inline constexpr std::size_t kMaxOwners = 64;

/// Assigns each cell (PlanView::Cell::owner) to the nearest person whose trunk is in the same component, or
/// within whose reach a disconnected part lies. `people`: middles of the trunks (m), nullopt for those who
/// are not in the image; at most kMaxOwners. After plan.join(). Does not allocate or throw.
void assignCells(std::span<const std::optional<PlanView::Place>> people, PlanView& plan);

}  // namespace abstand::tracking
