// The thesis's voxelmap: integer layers about the surface.
#include "core/haptic/voxelmap.hpp"

#include <algorithm>
#include <limits>

#include "core/haptic/voxelmap_sides.hpp"

namespace abstand {
namespace {

constexpr std::int16_t kMostSteps = std::numeric_limits<std::int16_t>::max();

std::int16_t next(std::int16_t steps) { return steps < kMostSteps ? steps + 1 : kMostSteps; }

// Number of 26-neighbour steps to the nearest surface voxel (0 there, kMostSteps elsewhere on entry). Two
// sweeps over half of the neighbours each give the same as breadth-first steps: Rosenfeld, Pfaltz, Distance
// Functions on Digital Pictures (1968). Such a shortest way never crosses the surface, so the sides need not
// be watched.
void countSteps(const VoxelGrid& grid, std::vector<std::int16_t>& steps) {
  const int nx = grid.size.x(), ny = grid.size.y(), nz = grid.size.z();
  // The least of three rows' neighbours, with one more at each end that does not count.
  std::vector<std::int16_t> least(nx + 2, kMostSteps);
  const auto sweepRow = [&](int j, int k, int direction) {
    std::fill(least.begin(), least.end(), kMostSteps);
    const auto lower = [&](int jj, int kk) {
      if (jj < 0 || jj >= ny || kk < 0 || kk >= nz) return;
      const std::int16_t* row = &steps[grid.index(0, jj, kk)];
      for (int i = 0; i < nx; ++i) least[i + 1] = std::min(least[i + 1], row[i]);
    };
    for (int dj = -1; dj <= 1; ++dj) lower(j + dj, k - direction);
    lower(j - direction, k);
    std::int16_t* row = &steps[grid.index(0, j, k)];
    for (int i = 0; i < nx; ++i) {
      row[i] = std::min(row[i], next(std::min({least[i], least[i + 1], least[i + 2]})));
    }
    if (direction > 0) {
      for (int i = 1; i < nx; ++i) row[i] = std::min(row[i], next(row[i - 1]));
    } else {
      for (int i = nx - 2; i >= 0; --i) row[i] = std::min(row[i], next(row[i + 1]));
    }
  };
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) sweepRow(j, k, 1);
  }
  for (int k = nz - 1; k >= 0; --k) {
    for (int j = ny - 1; j >= 0; --j) sweepRow(j, k, -1);
  }
}

}  // namespace

Voxelmap makeVoxelmap(const Surface& surface, double voxel_size, int outer_layers, int threads) {
  Voxelmap map;
  map.grid = makeGrid(surface.bounds(), voxel_size, outer_layers, kMostDenseVoxels);
  map.inside_doubtful = !surface.watertight();
  const VoxelSides sides = findVoxelSides(surface, voxel_size, threads);
  map.surface_voxels = sides.surface_voxels;
  map.solid_voxels = sides.solid_voxels;

  map.layer.assign(map.grid.cells(), kMostSteps);
  const Vector3i n = sides.grid.size;
  const auto forInner = [&](auto&& fn) {
    for (int k = 0; k < n.z(); ++k) {
      for (int j = 0; j < n.y(); ++j) {
        const std::int8_t* from = &sides.side[sides.grid.index(0, j, k)];
        std::int16_t* to = &map.layer[map.grid.index(outer_layers, j + outer_layers, k + outer_layers)];
        for (int i = 0; i < n.x(); ++i) fn(from[i], to[i]);
      }
    }
  };
  forInner([](std::int8_t side, std::int16_t& layer) {
    if (side == kVoxelSurface) layer = 0;
  });
  countSteps(map.grid, map.layer);
  for (std::int16_t& layer : map.layer) layer = static_cast<std::int16_t>(-layer);
  forInner([](std::int8_t side, std::int16_t& layer) {
    if (side == kVoxelInside) layer = static_cast<std::int16_t>(-layer);
  });
  return map;
}

}  // namespace abstand
