// The thesis's voxelmap: integer layers about the surface.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/surface.hpp"
#include "core/haptic/grid.hpp"

namespace abstand {

/// Layer of each voxel: 0 where the surface passes through (separating-axis test of triangle and cube),
/// +k for the k-th layer inside, -k for the k-th layer outside [thesis 2.2]. Layers are counted by
/// 26-neighbour steps away from the surface voxels. Constant after construction.
struct Voxelmap {
  VoxelGrid grid;
  std::vector<std::int16_t> layer;  ///< grid.index order
  std::size_t surface_voxels{0};    ///< layer 0
  std::size_t solid_voxels{0};      ///< layer >= 0
  bool inside_doubtful{false};      ///< the mesh is not watertight; winding numbers decided

  std::int16_t at(const Vector3i& v) const { return layer[grid.index(v.x(), v.y(), v.z())]; }
  template <class Archive>
  void archive(Archive& ar) {
    ar(grid, layer, surface_voxels, solid_voxels, inside_doubtful);
  }
};

/// Voxelizes on `threads` threads (0: as many as the machine has); the result is the same for any number.
/// Throws UsageError when the grid would be too large (makeGrid). How surface and inside are decided:
/// voxelmap_sides.hpp.
Voxelmap makeVoxelmap(const Surface& surface, double voxel_size, int outer_layers, int threads = 0);

}  // namespace abstand
