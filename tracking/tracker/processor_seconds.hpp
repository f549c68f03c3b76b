// Processor time of this process.
#pragma once

#include <ctime>

namespace abstand::tracking {

/// s, of all threads of the process.
inline double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace abstand::tracking
