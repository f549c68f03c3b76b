// Samples of the blocks of a near field.
#pragma once

#include <cstdint>
#include <vector>

#include "core/field/near_blocks.hpp"
#include "core/geometry/surface.hpp"

namespace abstand::field {

/// Signed distances (m) at the vertices of the stored blocks, NearField::kBlockValues for each. Exact up to
/// `rounding` (m), the error of a vertex position. The result does not depend on the number of threads.
std::vector<float> sampleBlocks(const geometry::Surface& surface, const SelectedBlocks& kept, double rounding,
                                int threads);

/// The same as multiples of `quantum` (m), without storing the floats of all blocks.
std::vector<std::int16_t> sampleQuanta(const geometry::Surface& surface, const SelectedBlocks& kept,
                                       double rounding, float quantum, int threads);

}  // namespace abstand::field
