// Random numbers of the checks.
#pragma once

#include "core/math/random.hpp"

namespace abstand::verify {
using abstand::Random;
}  // namespace abstand::verify
