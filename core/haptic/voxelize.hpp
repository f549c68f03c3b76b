// Which voxels a surface passes through. Internal to core/haptic.
#pragma once

#include <vector>

#include "core/geometry/triangle_mesh.hpp"
#include "core/haptic/grid.hpp"

namespace abstand {

/// Separating-axis test of a triangle and an axis-aligned cube about the origin (Akenine-Moeller, Fast 3D
/// Triangle-Box Overlap Testing, 2001). Touching counts as overlapping.
bool triangleOverlapsCube(const Vector3d& a, const Vector3d& b, const Vector3d& c, double half_edge);

/// 1 for every voxel that some triangle touches, grid.index order.
std::vector<char> surfaceVoxels(const TriangleMesh& mesh, const VoxelGrid& grid);

}  // namespace abstand
