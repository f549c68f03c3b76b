// Random poses with a fixed seed.
#pragma once

#include <cstdint>

#include "core/math/transform.hpp"

namespace abstand::testing {

/// Uniform rotation, position uniform in the cube [-reach, reach]^3. The same on every machine.
Transform randomPose(std::uint64_t seed, double reach = 1.0);

/// Uniform in [0, 1), the same on every machine; `stream` picks an independent number of the same seed.
double randomUnit(std::uint64_t seed, std::uint64_t stream);

}  // namespace abstand::testing
