// What one body does to another, the other does to it.
#pragma once

#include "core/verify/check.hpp"

namespace abstand::verify {

/// - third_law: the moments of both forces about any point cancel, relative to the sum of their sizes.
/// - exchange: asking for (B, A) gives the same as (A, B) to the last bit, but for pairs whose bodies are of
///   one size, where the order decides which of them gives the points.
std::vector<CheckResult> checkThirdLaw(const VerifyOptions& options);

}  // namespace abstand::verify
