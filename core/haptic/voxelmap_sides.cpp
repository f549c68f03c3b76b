// Which voxels the surface passes through, and which lie inside.
#include "core/haptic/voxelmap_sides.hpp"

#include <algorithm>

#include "core/base/parallel.hpp"

namespace abstand {
namespace {

constexpr std::int8_t kUnknown = 2;

// Parts the voxels that are still unknown into pieces by steps through faces.
class Pieces {
 public:
  Pieces(const VoxelGrid& grid, std::vector<std::int8_t>& side) : grid_(grid), side_(side) {}

  // Gives `value` to all that is reached from seed, and collects it in order.
  const std::vector<std::size_t>& fill(std::size_t seed, std::int8_t value) {
    piece_.clear();
    take(seed, value);
    const std::size_t nx = grid_.size.x(), nxy = nx * grid_.size.y();
    for (std::size_t at = 0; at < piece_.size(); ++at) {
      const std::size_t v = piece_[at];
      const std::size_t i = v % nx, j = v / nx % grid_.size.y(), k = v / nxy;
      if (i > 0) take(v - 1, value);
      if (i + 1 < nx) take(v + 1, value);
      if (j > 0) take(v - nx, value);
      if (j + 1 < std::size_t(grid_.size.y())) take(v + nx, value);
      if (k > 0) take(v - nxy, value);
      if (k + 1 < std::size_t(grid_.size.z())) take(v + nxy, value);
    }
    return piece_;
  }
  bool atRim(std::size_t v) const {
    const Vector3i p = place(v);
    return (p.array() == 0).any() || (p.array() == grid_.size.array() - 1).any();
  }
  Vector3i place(std::size_t v) const {
    const std::size_t nx = grid_.size.x(), ny = grid_.size.y();
    return {static_cast<int>(v % nx), static_cast<int>(v / nx % ny), static_cast<int>(v / (nx * ny))};
  }
  Vector3d centre(std::size_t v) const {
    const Vector3i p = place(v);
    return grid_.centre(p.x(), p.y(), p.z());
  }

 private:
  void take(std::size_t v, std::int8_t value) {
    if (side_[v] != kUnknown) return;
    side_[v] = value;
    piece_.push_back(v);
  }
  const VoxelGrid& grid_;
  std::vector<std::int8_t>& side_;
  std::vector<std::size_t> piece_;
};

bool mostlyInside(const Surface& surface, const Pieces& pieces, const std::vector<std::size_t>& piece,
                  int asked) {
  const std::size_t step = std::max<std::size_t>(1, piece.size() / asked);
  int votes = 0;
  for (std::size_t i = step / 2; i < piece.size(); i += step) {
    votes += surface.inside(pieces.centre(piece[i])) ? 1 : -1;
  }
  return votes > 0;
}

void fillPieces(const Surface& surface, const VoxelGrid& grid, int threads, std::vector<std::int8_t>& side) {
  Pieces pieces(grid, side);
  const bool watertight = surface.watertight();
  for (std::size_t v = 0; v < side.size(); ++v) {
    if (side[v] == kUnknown && pieces.atRim(v)) pieces.fill(v, kVoxelOutside);
  }
  if (!watertight) {
    parallelFor(threads, grid.size.z(), [&](std::size_t k) {
      const std::size_t slice = std::size_t(grid.size.x()) * grid.size.y();
      for (std::size_t v = k * slice; v < (k + 1) * slice; ++v) {
        if (side[v] == kVoxelOutside && surface.inside(pieces.centre(v))) side[v] = kVoxelInside;
      }
    });
  }
  constexpr int kVotes = 31;
  for (std::size_t v = 0; v < side.size(); ++v) {
    if (side[v] != kUnknown) continue;
    const std::vector<std::size_t>& piece = pieces.fill(v, kVoxelOutside);
    if (!mostlyInside(surface, pieces, piece, watertight ? 1 : kVotes)) continue;
    for (const std::size_t w : piece) side[w] = kVoxelInside;
  }
}

}  // namespace

VoxelSides findVoxelSides(const Surface& surface, double voxel_size, int threads) {
  VoxelSides sides;
  sides.grid = makeGrid(surface.bounds(), voxel_size, 0);
  sides.side.assign(sides.grid.cells(), kUnknown);
  if (const Shape* shape = surface.shape()) {
    markShape(*shape, sides.grid, threads, sides.side);
  } else {
    markTriangles(surface.mesh(0.0), sides.grid, threads, sides.side);
    fillPieces(surface, sides.grid, threads, sides.side);
  }
  sides.surface_voxels = std::count(sides.side.begin(), sides.side.end(), kVoxelSurface);
  sides.solid_voxels = sides.surface_voxels + std::count(sides.side.begin(), sides.side.end(), kVoxelInside);
  return sides;
}

}  // namespace abstand
