// Check of Newton's third law.
#pragma once

#include "core/verify/check.hpp"

namespace abstand::verify {

/// - third_law: the moments of both forces about any point cancel, relative to the sum of their magnitudes.
/// - exchange: querying (B, A) gives exactly the same as (A, B), except for pairs of equal size, where the
/// order
///   decides which body gives the points.
std::vector<CheckResult> checkThirdLaw(const VerifyOptions& options);

}  // namespace abstand::verify
