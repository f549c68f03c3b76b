// What margins of one body part would have done, for a curve.
#pragma once

#include "core/margin/clearance_store.hpp"
#include "core/margin/inside_frames.hpp"
#include "core/margin/margin_outcome.hpp"

namespace abstand::margin {

/// The outcome of one part alone with these margins, from the first frame from which it can be judged: a row
/// of `tune` where all pairs of the part have the same margin.
MarginOutcome partOutcome(const ClearanceStore& store, std::size_t part, const PartMargins& margins,
                          const MarginOptions& options);

}  // namespace abstand::margin
