#include "core/haptic/voxelmap.hpp"

#include <limits>

#include "core/base/error.hpp"
#include "core/base/parallel.hpp"
#include "core/haptic/voxelize.hpp"

namespace abstand {
namespace {

constexpr double kSagittaPerVoxel = 0.02;  // a shape's tessellation, far below what a voxel can show
constexpr std::size_t kMostVoxels = std::size_t{1} << 31;

/// 26-neighbour steps to the nearest marked voxel: two sweeps of the chessboard distance transform (Borgefors
/// 1986), exact for this metric.
void countSteps(const VoxelGrid& grid, std::vector<std::int16_t>& steps) {
  const int nx = grid.size.x(), ny = grid.size.y(), nz = grid.size.z();
  const auto relax = [&](int i, int j, int k, int direction) {
    std::int16_t& here = steps[grid.index(i, j, k)];
    // The thirteen neighbours that the sweep has passed already.
    for (int dk = -1; dk <= 0; ++dk)
      for (int dj = -1; dj <= (dk < 0 ? 1 : 0); ++dj)
        for (int di = -1; di <= (dk < 0 || dj < 0 ? 1 : -1); ++di) {
          const int x = i + direction * di, y = j + direction * dj, z = k + direction * dk;
          if (x < 0 || y < 0 || z < 0 || x >= nx || y >= ny || z >= nz) continue;
          const std::int16_t there = steps[grid.index(x, y, z)];
          if (there < here - 1) here = static_cast<std::int16_t>(there + 1);
        }
  };
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) relax(i, j, k, 1);
  for (int k = nz - 1; k >= 0; --k)
    for (int j = ny - 1; j >= 0; --j)
      for (int i = nx - 1; i >= 0; --i) relax(i, j, k, -1);
}

/// Marks what the outside reaches through faces without crossing a surface voxel.
std::vector<char> floodOutside(const VoxelGrid& grid, const std::vector<char>& surface) {
  std::vector<char> outside(surface.size(), 0);
  std::vector<Vector3i> front;
  const auto visit = [&](const Vector3i& v) {
    if (!grid.contains(v)) return;
    const std::size_t at = grid.index(v.x(), v.y(), v.z());
    if (surface[at] || outside[at]) return;
    outside[at] = 1;
    front.push_back(v);
  };
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, w = (axis + 2) % 3;
    for (int a = 0; a < grid.size[u]; ++a)
      for (int b = 0; b < grid.size[w]; ++b)
        for (const int end : {0, grid.size[axis] - 1}) {
          Vector3i v;
          v[axis] = end;
          v[u] = a;
          v[w] = b;
          visit(v);
        }
  }
  while (!front.empty()) {
    const Vector3i v = front.back();
    front.pop_back();
    for (int axis = 0; axis < 3; ++axis)
      for (const int step : {-1, 1}) visit(v + step * Vector3i::Unit(axis));
  }
  return outside;
}

}  // namespace

Voxelmap makeVoxelmap(const Surface& surface, double voxel_size, int outer_layers, int threads) {
  Voxelmap map;
  map.grid = makeGrid(surface.bounds(), voxel_size, outer_layers);
  const VoxelGrid& grid = map.grid;
  const std::size_t cells = grid.cells();
  if (cells > kMostVoxels)
    throw UsageError("found " + std::to_string(cells) + " voxels, expected at most " +
                     std::to_string(kMostVoxels) + ": take a larger voxel or fewer outer layers");
  const std::vector<char> on_surface = surfaceVoxels(surface.mesh(kSagittaPerVoxel * voxel_size), grid);
  map.inside_doubtful = !surface.watertight();

  // Closed surfaces: what the outside does not reach is inside. Others: the winding number at the voxel's
  // centre.
  std::vector<char> outside;
  if (map.inside_doubtful) {
    outside.assign(cells, 0);
    parallelFor(threads, static_cast<std::size_t>(grid.size.z()), [&](std::size_t slab) {
      const int k = static_cast<int>(slab);
      for (int j = 0; j < grid.size.y(); ++j)
        for (int i = 0; i < grid.size.x(); ++i) {
          const std::size_t at = grid.index(i, j, k);
          if (!on_surface[at]) outside[at] = !surface.inside(grid.centre(i, j, k));
        }
    });
  } else {
    outside = floodOutside(grid, on_surface);
  }

  map.layer.resize(cells);
  for (std::size_t i = 0; i < cells; ++i)
    map.layer[i] = on_surface[i] ? std::int16_t{0} : std::numeric_limits<std::int16_t>::max();
  countSteps(grid, map.layer);
  for (std::size_t i = 0; i < cells; ++i) {
    if (on_surface[i]) ++map.surface_voxels;
    if (!outside[i]) ++map.solid_voxels;
    if (outside[i]) map.layer[i] = static_cast<std::int16_t>(-map.layer[i]);
  }
  return map;
}

}  // namespace abstand
