// The thesis's voxelmap: integer layers around the surface.
#pragma once

#include <cstdint>
#include <vector>

#include "core/field/grid.hpp"
#include "core/field/layer_view.hpp"
#include "core/geometry/surface.hpp"

namespace abstand::field {

/// Layer of each voxel: 0 where the surface passes through (separating-axis test of triangle and cube), +k
/// for the k-th layer inside, -k for the k-th layer outside [thesis 2.2]. Layers count 26-neighbour steps
/// from the surface voxels. Half a byte for each voxel near the surface; elsewhere in large maps two bytes
/// for each block (LayerView). Constant after construction.
class Voxelmap {
 public:
  /// Largest number of voxels of a map that stores every layer exactly. Larger maps do so only for blocks
  /// within kExactSteps of a surface voxel.
  static constexpr std::size_t kMaxExactVoxels = 32'000'000;
  static constexpr int kExactSteps = 16;

  VoxelGrid grid;
  std::size_t surface_voxels{0};  ///< layer 0
  std::size_t solid_voxels{0};    ///< layer >= 0
  bool inside_doubtful{false};    ///< the mesh is not watertight; winding numbers decided

  Voxelmap() = default;
  /// Voxelizes on `threads` threads (0: hardware concurrency); the result is the same for any number. Throws
  /// UsageError if the grid would be too large (makeGrid). Surface and inside tests: voxelmap_sides.hpp.
  Voxelmap(const geometry::Surface& surface, double voxel_size, int outer_layers, int threads = 0,
           std::size_t max_exact = kMaxExactVoxels);

  /// Layer of a voxel of the grid.
  int at(const Vector3i& v) const { return layerOf(view(), v.x(), v.y(), v.z()).layer; }
  /// Largest error of at(v) in steps: 0 near the surface.
  int slack(const Vector3i& v) const { return layerOf(view(), v.x(), v.y(), v.z()).slack; }
  /// View into this map, which must outlive it.
  LayerView view() const;
  std::size_t memoryBytes() const;

  template <class Archive>
  void archive(Archive& ar) {
    ar(grid, surface_voxels, solid_voxels, inside_doubtful, blocks_, block_index_, min_steps_, packed_,
       corner_steps_);
  }

 private:
  void makeWhole(const geometry::Surface& surface, int outer_layers, int threads);
  void makeInTiles(const geometry::Surface& surface, int outer_layers, int threads);

  Vector3i blocks_{Vector3i::Zero()};
  std::vector<std::int32_t> block_index_;
  std::vector<std::int16_t> min_steps_;
  std::vector<std::uint8_t> packed_;
  std::vector<std::int16_t> corner_steps_;
};

}  // namespace abstand::field
