// Structures that several tests share, built once a program.
#pragma once

#include "core/structure/haptic_structure.hpp"

namespace abstand::testing {

/// 5 mm voxels and points, 20 outer layers.
const structure::HapticStructure& structureOf(const geometry::Shape& shape, structure::FieldKind field,
                                              double spacing = 0.005);

}  // namespace abstand::testing
