// A body at a pose.
#pragma once

#include "core/structure/haptic_structure.hpp"

namespace abstand::query {

/// One of the two bodies of a query: structure and pose. Refers to both, which must outlive it.
struct PlacedBody {
  const structure::HapticStructure& body;
  const Transform& X_WB;
};

}  // namespace abstand::query
