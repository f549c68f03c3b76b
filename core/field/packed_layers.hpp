// Packed blocks of a voxelmap. Internal to the engine.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/field/layer_view.hpp"

namespace abstand::field {

/// Half a byte for each voxel (LayerView), block after block.
struct PackedLayers {
  std::vector<std::int16_t> min_steps;
  std::vector<std::uint8_t> packed;

  /// Adds a block and returns its index. steps(i, j, k) and inside(i, j, k) give its voxels.
  template <class Steps, class Inside>
  std::int32_t add(Steps&& steps, Inside&& inside) {
    constexpr int kEdge = LayerView::kEdge;
    std::array<std::int16_t, 2 * LayerView::kPackedBytes> of;
    std::array<bool, of.size()> in;
    std::size_t voxel = 0;
    for (int k = 0; k < kEdge; ++k) {
      for (int j = 0; j < kEdge; ++j) {
        for (int i = 0; i < kEdge; ++i, ++voxel) {
          of[voxel] = steps(i, j, k);
          in[voxel] = inside(i, j, k);
        }
      }
    }
    const std::int16_t smallest = *std::min_element(of.begin(), of.end());
    const auto half = [&](std::size_t v) { return (of[v] - smallest) | (in[v] ? LayerView::kInsideBit : 0); };
    for (std::size_t v = 0; v < of.size(); v += 2)
      packed.push_back(static_cast<std::uint8_t>(half(v) | half(v + 1) << 4));
    min_steps.push_back(smallest);
    return static_cast<std::int32_t>(min_steps.size() - 1);
  }
};

}  // namespace abstand::field
