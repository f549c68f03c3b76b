// Read-only view of a voxelmap for searches. Internal to the engine.
#pragma once

#include <cstddef>
#include <cstdint>

namespace abstand::field {

/// Blocks of kEdge^3 voxels. A block near the surface stores the layer of each voxel in half a byte: its
/// steps above the minimum of the block (at most 7, as neighbours differ by at most one step), and whether it
/// is inside. All voxels of a farther block lie on one side; their steps are interpolated from those at its
/// corners, which are stored as a lattice.
struct LayerView {
  static constexpr int kEdge = 8;
  static constexpr int kPackedBytes = kEdge * kEdge * kEdge / 2;
  static constexpr int kInsideBit = 8, kStepBits = 7;
  static constexpr std::int32_t kFarInside = -1, kFarOutside = -2;
  /// Largest error of the steps in a far block: interpolation between eight corners of a function that
  /// changes by at most one step for each voxel errs by at most the weighted mean distance to the corners,
  /// 4.875 steps, plus half a step of rounding.
  static constexpr int kFarSlack = 6;

  const std::int32_t* block_index;  ///< index of the packed block, or kFarInside, kFarOutside
  const std::int16_t* min_steps;    ///< minimum of each packed block
  const std::uint8_t* packed;  ///< kPackedBytes for each block; voxels in the order x, y, z, the lower half
                               ///< byte first
  const std::int16_t* corner_steps;  ///< at voxels (8 i, 8 j, 8 k), one more along each axis than blocks
  int blocks[3];
};

namespace {

struct LayerOfVoxel {
  int layer;  ///< positive inside
  int slack;  ///< largest error of the step count
};

/// Layer of voxel (i, j, k), which must lie in the grid. In an unnamed namespace, as each kernel compiles its
/// own copy.
inline LayerOfVoxel layerOf(const LayerView& map, int i, int j, int k) {
  constexpr int kEdge = LayerView::kEdge, kShift = 3, kMask = kEdge - 1;
  const std::ptrdiff_t bi = i >> kShift, bj = j >> kShift, bk = k >> kShift;
  const int x = i & kMask, y = j & kMask, z = k & kMask;
  const std::int32_t block = map.block_index[(bk * map.blocks[1] + bj) * map.blocks[0] + bi];
  if (block >= 0) {
    const int voxel = (z * kEdge + y) * kEdge + x;
    const std::uint8_t two = map.packed[std::ptrdiff_t{block} * LayerView::kPackedBytes + voxel / 2];
    const int half = voxel % 2 == 0 ? two & 15 : two >> 4;
    const int steps = map.min_steps[block] + (half & LayerView::kStepBits);
    return {(half & LayerView::kInsideBit) != 0 ? steps : -steps, 0};
  }
  const std::ptrdiff_t row = map.blocks[0] + 1, slice = row * (map.blocks[1] + 1);
  const std::int16_t* corner = map.corner_steps + bk * slice + bj * row + bi;
  const auto along_x = [&](std::ptrdiff_t at) { return (kEdge - x) * corner[at] + x * corner[at + 1]; };
  const auto along_y = [&](std::ptrdiff_t at) { return (kEdge - y) * along_x(at) + y * along_x(at + row); };
  const int sum = (kEdge - z) * along_y(0) + z * along_y(slice);
  constexpr int kWhole = kEdge * kEdge * kEdge;
  const int steps = (sum + kWhole / 2) / kWhole;
  return {block == LayerView::kFarInside ? steps : -steps, LayerView::kFarSlack};
}

}  // namespace
}  // namespace abstand::field
