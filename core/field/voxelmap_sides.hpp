// Classifies voxels as surface, inside or outside.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/field/grid.hpp"
#include "core/geometry/surface.hpp"

namespace abstand::field {

inline constexpr std::int8_t kVoxelOutside = -1;
inline constexpr std::int8_t kVoxelSurface = 0;
inline constexpr std::int8_t kVoxelInside = 1;

struct VoxelSides {
  VoxelGrid grid;                 ///< without outer layers
  std::vector<std::int8_t> side;  ///< grid.index order
  std::size_t surface_voxels{0};
  std::size_t solid_voxels{0};  ///< surface and inside
};

/// Voxels are closed cubes; touching counts as passing through. Surface voxels of a mesh: separating-axis
/// test of triangle and cube. Of a shape, which is convex: exact, from its distance function. Inside of a
/// mesh: the other voxels are divided into components enclosed by surface voxels; the component at the grid's
/// border is outside, each other one is tested at one voxel. If the mesh is not watertight, an enclosed
/// component is decided by the majority of several voxels, and every voxel of the border component is tested,
/// as it may reach inside through a hole.
VoxelSides findVoxelSides(const geometry::Surface& surface, double voxel_size, int threads);

/// Sets `side` for a part of a larger grid, whose surface may end anywhere at the part's border: each
/// component of the part is tested like an enclosed one. Runs on the calling thread.
void findSidesOfPart(const geometry::Surface& surface, const VoxelGrid& part, std::vector<std::int8_t>& side);

/// Numbers of voxels by class.
struct VoxelCounts {
  std::size_t surface{0};
  std::size_t solid{0};  ///< surface and inside
};
/// Counts without storing the voxels: grids above `max_at_once` voxels are counted in cubes, of which only
/// those near the surface are voxelized. In these each component is tested like an enclosed one.
inline constexpr std::size_t kMaxVoxelsAtOnce = 64'000'000;
VoxelCounts countVoxels(const geometry::Surface& surface, double voxel_size, int threads,
                        std::size_t max_at_once = kMaxVoxelsAtOnce);

/// Sets `side` to kVoxelSurface where a triangle passes through the voxel.
void markTriangles(const geometry::TriangleMesh& mesh, const VoxelGrid& grid, int threads,
                   std::vector<std::int8_t>& side);
/// The same for one triangle.
void markTriangle(const std::array<Vector3d, 3>& triangle, const VoxelGrid& grid,
                  std::vector<std::int8_t>& side);
/// Sets all of `side`.
void markShape(const geometry::Shape& shape, const VoxelGrid& grid, int threads,
               std::vector<std::int8_t>& side);

}  // namespace abstand::field
