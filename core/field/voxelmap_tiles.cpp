// A large voxelmap, computed tile by tile: time and memory are proportional to the surface.
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

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
// Each tile is extended by this many voxels. The steps of a block within kExactSteps of the surface are at
// most 7 above that, so they are exact; so are all steps that do not exceed the halo.
constexpr int kHalo = 24;
static_assert(kHalo >= Voxelmap::kExactSteps + kEdge - 1);

struct Tile {
  PackedLayers layers;
  std::size_t surface_voxels{0}, solid_voxels{0};
};

// Boxes of a map. Tiles include all corners of blocks, also those at the far end of the grid.
struct TileLayout {
  TileLayout(const VoxelGrid& of, const Vector3i& block_count, int outer_layers)
      : grid(of),
        solid{Vector3i::Constant(outer_layers), of.size.array() - 2 * outer_layers},
        blocks{Vector3i::Zero(), block_count},
        corners{Vector3i::Zero(), block_count.array() + 1},
        tiles{Vector3i::Zero(), (corners.size.array() + kTileBlocks - 1) / kTileBlocks} {}

  // The blocks, or corners of blocks, that belong to a tile.
  VoxelBox inTile(std::size_t tile, const VoxelBox& all) const {
    return VoxelBox{kTileBlocks * tiles.place(tile), Vector3i::Constant(kTileBlocks)}.clippedTo(all);
  }

  const VoxelGrid& grid;
  VoxelBox solid;  // voxels without the outer layers
  VoxelBox blocks, corners, tiles;
};

// Computes one tile. Its blocks and corners in the shared tables are written by no other tile.
class TileMaker {
 public:
  TileMaker(const geometry::Surface& surface, const TileLayout& layout, std::size_t number)
      : surface_(surface),
        layout_(layout),
        number_(number),
        seen_{kTile * layout.tiles.place(number) - Vector3i::Constant(kHalo),
              Vector3i::Constant(kTile + 2 * kHalo)},
        seen_solid_(seen_.clippedTo(layout.solid)),
        own_solid_(
            VoxelBox{kTile * layout.tiles.place(number), Vector3i::Constant(kTile)}.clippedTo(layout.solid)) {
  }

  Tile make(std::vector<std::int32_t>& block_index, std::vector<std::int16_t>& corner_steps) {
    Tile tile;
    if (const std::optional<bool> inside = oneSide()) {
      markBlocks(*inside, block_index);
      if (*inside) tile.solid_voxels = own_solid_.count();
      return tile;
    }
    findSteps();
    countTile(tile);
    packBlocks(tile, block_index);
    storeCorners(corner_steps);
    return tile;
  }

 private:
  // The part of the grid that the tile sees, without outer layers.
  VoxelGrid part() const {
    const Vector3i& first = seen_solid_.first;
    return {layout_.grid.centre(first.x(), first.y(), first.z()), layout_.grid.voxel_size, seen_solid_.size};
  }

  // If all voxels that the tile sees lie on one side of the surface: whether inside.
  std::optional<bool> oneSide() const {
    if (seen_solid_.count() == 0) return false;
    const VoxelGrid grid = part();
    const Vector3d half = 0.5 * grid.voxel_size * (grid.size.array() - 1).matrix().cast<double>();
    const Vector3d middle = grid.first_centre + half;
    const geometry::SurfacePoint nearest = surface_.closest(middle);
    // One voxel diagonal more: a surface beside the box classifies none of its voxels.
    if (nearest.distance > half.norm() + kCubeDiagonal * grid.voxel_size)
      return surface_.inside(middle, nearest);
    return std::nullopt;
  }

  void markBlocks(bool inside, std::vector<std::int32_t>& block_index) const {
    layout_.inTile(number_, layout_.blocks).forEach([&](const Vector3i& b) {
      block_index[layout_.blocks.index(b)] = farBlock(inside);
    });
  }
  static std::int32_t farBlock(bool inside) {
    return inside ? LayerView::kFarInside : LayerView::kFarOutside;
  }

  void findSteps() {
    findSidesOfPart(surface_, part(), side_);
    steps_.assign(seen_.count(), kMaxSteps);
    bool any = false;
    seen_solid_.forEach([&](const Vector3i& v) {
      if (side_[seen_solid_.index(v)] == kVoxelSurface) steps_[seen_.index(v)] = 0, any = true;
    });
    if (any) countSteps(seen_.size, 1, steps_);
  }

  void countTile(Tile& tile) const {
    own_solid_.forEach([&](const Vector3i& v) {
      const std::int8_t s = side_[seen_solid_.index(v)];
      tile.surface_voxels += s == kVoxelSurface;
      tile.solid_voxels += s != kVoxelOutside;
    });
  }

  bool inside(const Vector3i& v) const {
    const Vector3i at = v.cwiseMin(layout_.grid.size - Vector3i::Ones());
    return seen_solid_.contains(at) && side_[seen_solid_.index(at)] == kVoxelInside;
  }

  void packBlocks(Tile& tile, std::vector<std::int32_t>& block_index) const {
    layout_.inTile(number_, layout_.blocks).forEach([&](const Vector3i& b) {
      const Vector3i first = kEdge * b;
      const VoxelBox block{first, Vector3i::Constant(kEdge)};
      std::int16_t smallest = kMaxSteps;
      block.forEach([&](const Vector3i& v) { smallest = std::min(smallest, steps_[seen_.index(v)]); });
      std::int32_t& index = block_index[layout_.blocks.index(b)];
      if (smallest > Voxelmap::kExactSteps) {
        index = farBlock(inside(first + Vector3i::Constant(kEdge / 2)));
        return;
      }
      index =
          tile.layers.add([&](int i, int j, int k) { return steps_[seen_.index(first + Vector3i(i, j, k))]; },
                          [&](int i, int j, int k) { return inside(first + Vector3i(i, j, k)); });
    });
  }

  void storeCorners(std::vector<std::int16_t>& corner_steps) const {
    layout_.inTile(number_, layout_.corners).forEach([&](const Vector3i& c) {
      const std::int16_t s = steps_[seen_.index(kEdge * c)];
      if (s <= kHalo) corner_steps[layout_.corners.index(c)] = s;
    });
  }

  const geometry::Surface& surface_;
  const TileLayout& layout_;
  const std::size_t number_;
  const VoxelBox seen_, seen_solid_, own_solid_;  // in voxels; seen_ includes the halo
  std::vector<std::int8_t> side_;                 // for seen_solid_
  std::vector<std::int16_t> steps_;               // for seen_
};

}  // namespace

void Voxelmap::makeInTiles(const geometry::Surface& surface, int outer_layers, int threads) {
  const TileLayout layout(grid, blocks_, outer_layers);
  corner_steps_.assign(layout.corners.count(), kMaxSteps);
  std::vector<Tile> made(layout.tiles.count());
  parallelFor(threads, made.size(), [&](std::size_t at) {
    made[at] = TileMaker(surface, layout, at).make(block_index_, corner_steps_);
  });

  // Farther than the halo, the shortest path from a corner passes through one of its 26 neighbour corners:
  // its longest component exceeds 16 steps, and other components within 8 of it are shortened too.
  countSteps(layout.corners.size, kEdge, corner_steps_);

  std::size_t kept = 0;
  for (const Tile& tile : made) kept += tile.layers.min_steps.size();
  min_steps_.reserve(kept);
  packed_.reserve(kept * LayerView::kPackedBytes);
  for (std::size_t t = 0; t < made.size(); ++t) {
    PackedLayers layers = std::move(made[t].layers);
    const auto before = static_cast<std::int32_t>(min_steps_.size());
    min_steps_.insert(min_steps_.end(), layers.min_steps.begin(), layers.min_steps.end());
    packed_.insert(packed_.end(), layers.packed.begin(), layers.packed.end());
    surface_voxels += made[t].surface_voxels;
    solid_voxels += made[t].solid_voxels;
    layout.inTile(t, layout.blocks).forEach([&](const Vector3i& b) {
      if (std::int32_t& index = block_index_[layout.blocks.index(b)]; index >= 0) index += before;
    });
  }
}

}  // namespace abstand::field
