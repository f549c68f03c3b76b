// Classifies voxels as surface, inside or outside.
#include "core/field/voxelmap_sides.hpp"

#include <algorithm>

#include "core/base/parallel.hpp"
#include "core/geometry/mesh_surface.hpp"

namespace abstand::field {
namespace {

constexpr std::int8_t kUnknown = 2;

// Divides the voxels that are still unknown into components connected through faces (flood fill).
class Pieces {
 public:
  Pieces(const VoxelGrid& grid, std::vector<std::int8_t>& side) : grid_(grid), side_(side) {}

  /// Consecutive voxels along x.
  struct Run {
    std::size_t first, count;
  };

  // Sets `value` for the component of `seed`, and returns its runs.
  const std::vector<Run>& fill(std::size_t seed, std::int8_t value) {
    piece_.clear();
    seeds_.assign(1, seed);
    const std::size_t nx = grid_.size.x(), ny = grid_.size.y(), nz = grid_.size.z();
    while (!seeds_.empty()) {
      const std::size_t at = seeds_.back();
      seeds_.pop_back();
      if (side_[at] != kUnknown) continue;
      const std::size_t row = at / nx, begin = row * nx;
      std::size_t first = at, end = at + 1;
      while (first > begin && side_[first - 1] == kUnknown) --first;
      while (end < begin + nx && side_[end] == kUnknown) ++end;
      std::fill(&side_[first], &side_[first] + (end - first), value);
      piece_.push_back({first, end - first});
      const std::size_t j = row % ny, k = row / ny;
      if (j > 0) searchRow(first - nx, end - nx);
      if (j + 1 < ny) searchRow(first + nx, end + nx);
      if (k > 0) searchRow(first - nx * ny, end - nx * ny);
      if (k + 1 < nz) searchRow(first + nx * ny, end + nx * ny);
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
  // Adds one seed for each run of unknown voxels.
  void searchRow(std::size_t first, std::size_t end) {
    for (std::size_t v = first; v < end; ++v) {
      if (side_[v] == kUnknown && (v == first || side_[v - 1] != kUnknown)) seeds_.push_back(v);
    }
  }
  const VoxelGrid& grid_;
  std::vector<std::int8_t>& side_;
  std::vector<Run> piece_;
  std::vector<std::size_t> seeds_;
};

bool mostlyInside(const geometry::Surface& surface, const Pieces& pieces,
                  const std::vector<Pieces::Run>& piece, std::size_t asked) {
  std::size_t size = 0;
  for (const Pieces::Run& run : piece) size += run.count;
  const std::size_t step = std::max<std::size_t>(1, size / asked);
  int votes = 0;
  std::size_t next = step / 2, before = 0;
  for (const Pieces::Run& run : piece) {
    for (; next < before + run.count; next += step)
      votes += surface.inside(pieces.centre(run.first + next - before)) ? 1 : -1;
    before += run.count;
  }
  return votes > 0;
}

void fillEnclosed(const geometry::Surface& surface, const VoxelGrid& grid, std::vector<std::int8_t>& side) {
  Pieces pieces(grid, side);
  constexpr std::size_t kVotes = 31;
  for (std::size_t v = 0; v < side.size(); ++v) {
    if (side[v] != kUnknown) continue;
    const std::vector<Pieces::Run>& piece = pieces.fill(v, kVoxelOutside);
    if (!mostlyInside(surface, pieces, piece, surface.watertight() ? 1 : kVotes)) continue;
    for (const Pieces::Run& run : piece)
      std::fill(&side[run.first], &side[run.first] + run.count, kVoxelInside);
  }
}

void fillPieces(const geometry::Surface& surface, const VoxelGrid& grid, int threads,
                std::vector<std::int8_t>& side) {
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
  fillEnclosed(surface, grid, side);
}

VoxelCounts count(const std::vector<std::int8_t>& side) {
  VoxelCounts counts;
  counts.surface = static_cast<std::size_t>(std::count(side.begin(), side.end(), kVoxelSurface));
  counts.solid =
      counts.surface + static_cast<std::size_t>(std::count(side.begin(), side.end(), kVoxelInside));
  return counts;
}

}  // namespace

VoxelSides findVoxelSides(const geometry::Surface& surface, double voxel_size, int threads) {
  VoxelSides sides;
  sides.grid = makeGrid(surface.bounds(), voxel_size, 0);
  sides.side.assign(sides.grid.cells(), kUnknown);
  if (const geometry::Shape* shape = surface.shape()) {
    markShape(*shape, sides.grid, threads, sides.side);
  } else {
    markTriangles(surface.mesh(0.0), sides.grid, threads, sides.side);
    fillPieces(surface, sides.grid, threads, sides.side);
  }
  const VoxelCounts counts = count(sides.side);
  sides.surface_voxels = counts.surface;
  sides.solid_voxels = counts.solid;
  return sides;
}

void findSidesOfPart(const geometry::Surface& surface, const VoxelGrid& part,
                     std::vector<std::int8_t>& side) {
  side.assign(part.cells(), kUnknown);
  if (const geometry::Shape* shape = surface.shape()) return markShape(*shape, part, 1, side);
  const auto& mesh = dynamic_cast<const geometry::MeshSurface&>(surface);
  const Vector3d reach = Vector3d::Constant(part.voxel_size);
  const Vector3i last = part.size.array() - 1;
  const geometry::Bounds box{part.first_centre - reach, part.centre(last.x(), last.y(), last.z()) + reach};
  mesh.tree().forOverlapping(box, [&](std::uint32_t slot) {
    geometry::TriangleCorners t;
    if (mesh.triangle(slot, t)) markTriangle({t[0], t[1], t[2]}, part, side);
  });
  fillEnclosed(surface, part, side);
}

VoxelCounts countVoxels(const geometry::Surface& surface, double voxel_size, int threads,
                        std::size_t max_at_once) {
  const VoxelGrid grid = makeGrid(surface.bounds(), voxel_size, 0);
  if (grid.cells() <= max_at_once) {
    const VoxelSides sides = findVoxelSides(surface, voxel_size, threads);
    return {sides.surface_voxels, sides.solid_voxels};
  }
  constexpr int kEdge = 32;
  const Vector3i cubes = (grid.size.array() + kEdge - 1) / kEdge;
  std::vector<VoxelCounts> of_row(static_cast<std::size_t>(cubes.y()) * static_cast<std::size_t>(cubes.z()));
  parallelFor(threads, of_row.size(), [&](std::size_t row) {
    std::uint32_t hint = geometry::kNoHint;
    std::vector<std::int8_t> side;
    for (int i = 0; i < cubes.x(); ++i) {
      const Vector3i first =
          kEdge * Vector3i(i, static_cast<int>(row) % cubes.y(), static_cast<int>(row) / cubes.y());
      VoxelGrid cube{grid.centre(first.x(), first.y(), first.z()), voxel_size,
                     (grid.size - first).cwiseMin(Vector3i::Constant(kEdge))};
      const Vector3d middle =
          cube.first_centre + 0.5 * voxel_size * (cube.size.array() - 1).matrix().cast<double>();
      const geometry::SurfacePoint nearest = surface.closest(middle, hint);
      hint = nearest.hint;
      VoxelCounts counts;
      // One voxel more: a surface beside a cube classifies none of its voxels.
      if (nearest.distance > 0.5 * kCubeDiagonal * (kEdge + 1) * voxel_size)
        counts.solid = surface.inside(middle, nearest) ? cube.cells() : 0;
      else
        findSidesOfPart(surface, cube, side), counts = count(side);
      of_row[row].surface += counts.surface;
      of_row[row].solid += counts.solid;
    }
  });
  VoxelCounts all;
  for (const VoxelCounts& row : of_row) {
    all.surface += row.surface;
    all.solid += row.solid;
  }
  return all;
}

}  // namespace abstand::field
