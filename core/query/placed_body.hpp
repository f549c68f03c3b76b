// A body at a pose.
#pragma once

#include "core/structure/haptic_structure.hpp"

namespace abstand::query {

/// What a query needs to know of each of its two bodies. Refers to both, which must outlive it.
struct PlacedBody {
  const structure::HapticStructure& body;
  const Transform& X_WB;
};

}  // namespace abstand::query
