// Contacts between the points of the pointshells.
#pragma once

#include "core/query/placed_body.hpp"

namespace abstand::query {

/// Overlap (m, >= 0) of the margins of two bodies whose shell points do not touch: local search on the exact
/// surfaces for the nearest points, starting at a shell point of A, of B, or of both (`near_a`, `near_b`:
/// leaf order, from penaltyForce(); kNoPoint: none). World poses, margin in m. No allocation, no lock, no
/// throw.
double depthBetweenPoints(const PlacedBody& a, std::uint32_t near_a, const PlacedBody& b,
                          std::uint32_t near_b, double margin) noexcept;

}  // namespace abstand::query
