// Check of certified distances of moving bodies with warm starts, against exact distances.
#pragma once

#include "core/verify/check.hpp"

namespace abstand::verify {

/// Moves pairs of adversarial bodies from adversarial poses, in steps from a micrometre to a centimetre with
/// matching rotations, and calls queryPair() each time with the pair memory of the step before, as in every
/// cycle. One fifth of options.poses. The result bound.moving is defined as bound.FIELD of
/// checkCertifiedBound(); the table has one row for each step size.
std::vector<CheckResult> checkMovingBound(const VerifyOptions& options);

}  // namespace abstand::verify
