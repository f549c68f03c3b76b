// A large voxelmap, made tile by tile, so that time and memory go with the surface.
#include <algorithm>
#include <utility>

#include "core/base/parallel.hpp"
#include "core/field/packed_layers.hpp"
#include "core/field/voxel_box.hpp"
#include "core/field/voxel_steps.hpp"
#include "core/field/voxelmap.hpp"
#include "core/field/voxelmap_sides.hpp"

namespace abstand::field {
namespace {

constexpr int kEdge = LayerView::kEdge;
constexpr int kTileBlocks = 12;
constexpr int kTile = kTileBlocks * kEdge;
// A tile sees the surface so far beyond its own voxels. The steps of a block that comes within kExactSteps of
// it are no more than 7 above that, and so exact; and so are all that do not exceed the halo.
constexpr int kHalo = 24;
static_assert(kHalo >= Voxelmap::kExactSteps + kEdge - 1);

struct Tile {
  PackedLayers layers;
  std::size_t surface_voxels{0}, solid_voxels{0};
};

}  // namespace

void Voxelmap::makeInTiles(const geometry::Surface& surface, int outer_layers, int threads) {
  const Vector3i zero = Vector3i::Zero();
  const VoxelBox blocks{zero, blocks_}, corners{zero, blocks_.array() + 1};
  corner_steps_.assign(corners.count(), kMaxSteps);
  const VoxelBox solid{Vector3i::Constant(outer_layers), grid.size.array() - 2 * outer_layers};
  // Tiles hold all corners of blocks, those at the far end of the grid included.
  const VoxelBox tiles{zero, (corners.size.array() + kTileBlocks - 1) / kTileBlocks};
  const auto inTile = [&](std::size_t tile, const VoxelBox& all) {
    return VoxelBox{kTileBlocks * tiles.place(tile), Vector3i::Constant(kTileBlocks)}.clippedTo(all);
  };
  std::vector<Tile> made(tiles.count());
  parallelFor(threads, made.size(), [&](std::size_t at) {
    Tile& tile = made[at];
    const VoxelBox own{kTile * tiles.place(at), Vector3i::Constant(kTile)};
    const VoxelBox seen{own.first.array() - kHalo, Vector3i::Constant(kTile + 2 * kHalo)};
    const VoxelBox own_solid = own.clippedTo(solid), seen_solid = seen.clippedTo(solid);
    const VoxelBox own_blocks = inTile(at, blocks);
    const auto allFar = [&](bool inside) {
      own_blocks.forEach([&](const Vector3i& b) {
        block_index_[blocks.index(b)] = inside ? LayerView::kFarInside : LayerView::kFarOutside;
      });
      if (inside) tile.solid_voxels = own_solid.count();
    };

    if (seen_solid.count() == 0) return allFar(false);
    const VoxelGrid part{grid.centre(seen_solid.first.x(), seen_solid.first.y(), seen_solid.first.z()),
                         grid.voxel_size, seen_solid.size};
    const Vector3d half = 0.5 * grid.voxel_size * (part.size.array() - 1).matrix().cast<double>();
    const Vector3d middle = part.first_centre + half;
    const geometry::SurfacePoint nearest = surface.closest(middle);
    // A voxel's diagonal more: a surface beside the box decides about none of its voxels.
    if (nearest.distance > half.norm() + kCubeDiagonal * grid.voxel_size)
      return allFar(surface.inside(middle, nearest));

    std::vector<std::int8_t> side;
    findSidesOfPart(surface, part, side);
    std::vector<std::int16_t> steps(seen.count(), kMaxSteps);
    bool any = false;
    seen_solid.forEach([&](const Vector3i& v) {
      if (side[seen_solid.index(v)] == kVoxelSurface) steps[seen.index(v)] = 0, any = true;
    });
    own_solid.forEach([&](const Vector3i& v) {
      const std::int8_t s = side[seen_solid.index(v)];
      tile.surface_voxels += s == kVoxelSurface;
      tile.solid_voxels += s != kVoxelOutside;
    });
    if (any) countSteps(seen.size, 1, steps);

    const auto inside = [&](const Vector3i& v) {
      const Vector3i at_v = v.cwiseMin(grid.size - Vector3i::Ones());
      return seen_solid.contains(at_v) && side[seen_solid.index(at_v)] == kVoxelInside;
    };
    own_blocks.forEach([&](const Vector3i& b) {
      const Vector3i first = kEdge * b;
      const VoxelBox block{first, Vector3i::Constant(kEdge)};
      std::int16_t least = kMaxSteps;
      block.forEach([&](const Vector3i& v) { least = std::min(least, steps[seen.index(v)]); });
      std::int32_t& index = block_index_[blocks.index(b)];
      if (least > kExactSteps) {
        index =
            inside(first + Vector3i::Constant(kEdge / 2)) ? LayerView::kFarInside : LayerView::kFarOutside;
        return;
      }
      index =
          tile.layers.add([&](int i, int j, int k) { return steps[seen.index(first + Vector3i(i, j, k))]; },
                          [&](int i, int j, int k) { return inside(first + Vector3i(i, j, k)); });
    });
    inTile(at, corners).forEach([&](const Vector3i& c) {
      const std::int16_t s = steps[seen.index(kEdge * c)];
      if (s <= kHalo) corner_steps_[corners.index(c)] = s;
    });
  });

  // Farther away than the halo, the shortest way from a corner leads over one of the 26 corners about it: its
  // longest component is more than 16 steps, and whichever others are within 8 of that are shortened with it.
  countSteps(corners.size, kEdge, corner_steps_);

  std::size_t kept = 0;
  for (const Tile& tile : made) kept += tile.layers.least_steps.size();
  least_steps_.reserve(kept);
  packed_.reserve(kept * LayerView::kPackedBytes);
  for (std::size_t t = 0; t < made.size(); ++t) {
    PackedLayers layers = std::move(made[t].layers);
    const auto before = static_cast<std::int32_t>(least_steps_.size());
    least_steps_.insert(least_steps_.end(), layers.least_steps.begin(), layers.least_steps.end());
    packed_.insert(packed_.end(), layers.packed.begin(), layers.packed.end());
    surface_voxels += made[t].surface_voxels;
    solid_voxels += made[t].solid_voxels;
    inTile(t, blocks).forEach([&](const Vector3i& b) {
      if (std::int32_t& index = block_index_[blocks.index(b)]; index >= 0) index += before;
    });
  }
}

}  // namespace abstand::field
