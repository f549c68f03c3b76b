// The thesis's voxelmap: integer layers about the surface.
#include "core/field/voxelmap.hpp"

#include <algorithm>

#include "core/field/packed_layers.hpp"
#include "core/field/voxel_box.hpp"
#include "core/field/voxel_steps.hpp"
#include "core/field/voxelmap_sides.hpp"

namespace abstand::field {

Voxelmap::Voxelmap(const geometry::Surface& surface, double voxel_size, int outer_layers, int threads,
                   std::size_t max_exact) {
  constexpr int kEdge = LayerView::kEdge;
  grid = makeGrid(surface.bounds(), voxel_size, outer_layers);
  inside_doubtful = !surface.watertight();
  blocks_ = (grid.size.array() + kEdge - 1) / kEdge;
  block_index_.resize(VoxelBox{Vector3i::Zero(), blocks_}.count());
  if (grid.cells() <= max_exact)
    makeWhole(surface, outer_layers, threads);
  else
    makeInTiles(surface, outer_layers, threads);
}

void Voxelmap::makeWhole(const geometry::Surface& surface, int outer_layers, int threads) {
  const VoxelSides sides = findVoxelSides(surface, grid.voxel_size, threads);
  surface_voxels = sides.surface_voxels;
  solid_voxels = sides.solid_voxels;
  const Vector3i outer = Vector3i::Constant(outer_layers);
  const auto side = [&](const Vector3i& v) {
    const Vector3i inner = v - outer;
    return sides.grid.contains(inner) ? sides.side[sides.grid.index(inner.x(), inner.y(), inner.z())]
                                      : kVoxelOutside;
  };

  std::vector<std::int16_t> steps(grid.cells(), kMaxSteps);
  const Vector3i n = sides.grid.size;
  for (int k = 0; k < n.z(); ++k) {
    for (int j = 0; j < n.y(); ++j) {
      const std::int8_t* from = &sides.side[sides.grid.index(0, j, k)];
      std::int16_t* to = &steps[grid.index(outer_layers, j + outer_layers, k + outer_layers)];
      for (int i = 0; i < n.x(); ++i)
        if (from[i] == kVoxelSurface) to[i] = 0;
    }
  }
  countSteps(grid.size, 1, steps);
  PackedLayers all;
  const VoxelBox blocks{Vector3i::Zero(), blocks_};
  for (std::size_t b = 0; b < block_index_.size(); ++b) {
    const Vector3i first = LayerView::kEdge * blocks.place(b);
    // Voxels beyond the grid are treated as its last ones.
    const auto inGrid = [&](int i, int j, int k) {
      return Vector3i((first + Vector3i(i, j, k)).cwiseMin(grid.size - Vector3i::Ones()));
    };
    block_index_[b] = all.add(
        [&](int i, int j, int k) {
          const Vector3i v = inGrid(i, j, k);
          return steps[grid.index(v.x(), v.y(), v.z())];
        },
        [&](int i, int j, int k) { return side(inGrid(i, j, k)) == kVoxelInside; });
  }
  min_steps_ = std::move(all.min_steps);
  packed_ = std::move(all.packed);
}

LayerView Voxelmap::view() const {
  return {block_index_.data(),
          min_steps_.data(),
          packed_.data(),
          corner_steps_.data(),
          {blocks_.x(), blocks_.y(), blocks_.z()}};
}

std::size_t Voxelmap::memoryBytes() const {
  return block_index_.capacity() * sizeof(block_index_[0]) +
         (min_steps_.capacity() + corner_steps_.capacity()) * sizeof(std::int16_t) + packed_.capacity();
}

}  // namespace abstand::field
