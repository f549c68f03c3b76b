// The samples of a near field's blocks.
#pragma once

#include <cstdint>
#include <vector>

#include "core/field/near_blocks.hpp"
#include "core/geometry/surface.hpp"

namespace abstand::field {

/// Signed distances (m) at the vertices of the kept blocks, NearField::kBlockValues of each, exact but for
/// `rounding` (m), by which a vertex may be moved. Any number of threads gives the same.
std::vector<float> sampleBlocks(const geometry::Surface& surface, const KeptBlocks& kept, double rounding,
                                int threads);

/// The same in multiples of `quantum` (m), without memory for the floats of all blocks.
std::vector<std::int16_t> sampleQuanta(const geometry::Surface& surface, const KeptBlocks& kept,
                                       double rounding, float quantum, int threads);

}  // namespace abstand::field
