// Work space of one pair query.
#pragma once

#include <cstdint>

#include "core/shell/point_sphere_tree.hpp"

namespace abstand::kernels {

/// Work space of one pair query. One for each pair or thread; no data persists between calls.
struct PairScratch {
  struct Entry {
    float lower_bound;  ///< of the true distance of every point below the node
    std::uint32_t node;
  };
  /// Depth-first search with at most kFanout - 1 siblings on the stack for each level; a tree of 2^32 points
  /// has 11 levels.
  Entry stack[16 * shell::PointSphereTree::kFanout];
};

}  // namespace abstand::kernels
