// The same bits for any number of threads.
#pragma once

#include "core/verify/check.hpp"

namespace abstand::verify {

/// A scene of all adversarial bodies and all their pairs, stepped with 1, 2, 3, 7 and 16 threads over random
/// poses: the fingerprint of all results is that of one thread. The number is 1 for a frame that differs.
std::vector<CheckResult> checkSameBits(const VerifyOptions& options);

}  // namespace abstand::verify
