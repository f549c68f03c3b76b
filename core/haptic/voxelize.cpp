#include "core/haptic/voxelize.hpp"

#include <algorithm>
#include <cmath>

namespace abstand {

bool triangleOverlapsCube(const Vector3d& a, const Vector3d& b, const Vector3d& c, double half_edge) {
  const auto separated = [&](const Vector3d& axis) {
    const double pa = axis.dot(a), pb = axis.dot(b), pc = axis.dot(c);
    const double reach = half_edge * axis.cwiseAbs().sum();
    return std::min({pa, pb, pc}) > reach || std::max({pa, pb, pc}) < -reach;
  };
  const Vector3d edges[3] = {b - a, c - b, a - c};
  for (int i = 0; i < 3; ++i) {
    if (separated(Vector3d::Unit(i))) return false;
    for (const Vector3d& e : edges)
      if (separated(Vector3d::Unit(i).cross(e))) return false;
  }
  return !separated(edges[0].cross(edges[1]));
}

std::vector<char> surfaceVoxels(const TriangleMesh& mesh, const VoxelGrid& grid) {
  std::vector<char> marked(grid.cells(), 0);
  const double half = 0.5 * grid.voxel_size;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Bounds box;
    for (int i = 0; i < 3; ++i) box.add(mesh.corner(t, i));
    const Vector3i lower = grid.voxelOf(box.lower.array() - half).cwiseMax(0);
    const Vector3i upper = grid.voxelOf(box.upper.array() + half).cwiseMin((grid.size.array() - 1).matrix());
    for (int k = lower.z(); k <= upper.z(); ++k)
      for (int j = lower.y(); j <= upper.y(); ++j)
        for (int i = lower.x(); i <= upper.x(); ++i) {
          char& mark = marked[grid.index(i, j, k)];
          if (mark) continue;
          const Vector3d centre = grid.centre(i, j, k);
          mark = triangleOverlapsCube(mesh.corner(t, 0) - centre, mesh.corner(t, 1) - centre,
                                      mesh.corner(t, 2) - centre, half);
        }
  }
  return marked;
}

}  // namespace abstand
