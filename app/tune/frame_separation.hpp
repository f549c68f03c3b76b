// Terms of the protective distance in every frame, from a result file.
#pragma once

#include "app/tune/pair_rows.hpp"

namespace abstand::tune {

/// For each of PassResult::parts: the pair whose protective distance S_p exceeds its clearance most in frame
/// `t`, with the terms; empty if no link moves towards the part, as S_p then asks for nothing. Files round
/// clearances and speeds to the safe side, so the excess is at least that of the pass
/// (PartSeparation::missing). `options`: those of the pass (PassOptions::separation).
std::vector<std::optional<SeparationMoment>> frameSeparation(const PassResult& pass,
                                                             const margin::PairFrame& frame,
                                                             const safety::SeparationOptions& options);

}  // namespace abstand::tune
