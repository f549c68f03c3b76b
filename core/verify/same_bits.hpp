// Check of bit-identical results for any number of threads.
#pragma once

#include "core/verify/check.hpp"

namespace abstand::verify {

/// A scene of all adversarial bodies and all their pairs, stepped with 1, 2, 3, 7 and 16 threads over random
/// poses: the hash of all results must equal that of one thread. The value is 1 for a frame that differs.
std::vector<CheckResult> checkSameBits(const VerifyOptions& options);

}  // namespace abstand::verify
