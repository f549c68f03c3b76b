// Contacts that the shell's points miss.
#pragma once

#include "core/query/placed_body.hpp"

namespace abstand::query {

/// How deep (m, >= 0) the margins of two bodies reach into each other between their shell points: that of the
/// nearest points to which a walk on the exact surfaces leads from a shell point of A, of B, or of both
/// (`near_a`, `near_b`: in leaf order, as penaltyForce() gives them; kNoPoint: none). World poses, margin in
/// m. No allocation, no lock, no throw.
double depthBetweenPoints(const PlacedBody& a, std::uint32_t near_a, const PlacedBody& b,
                          std::uint32_t near_b, double margin) noexcept;

}  // namespace abstand::query
