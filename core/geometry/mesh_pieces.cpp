// Connected components of a mesh, by union-find.
#include "core/geometry/mesh_pieces.hpp"

#include <numeric>

namespace abstand::geometry {

std::vector<Vector3d> pieces(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto rootOf = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const auto& triangle : mesh.triangles)
    for (const int corner : {1, 2})
      parent[rootOf(triangle[static_cast<std::size_t>(corner)])] = rootOf(triangle[0]);
  std::vector<char> seen(mesh.vertices.size(), 0);
  std::vector<Vector3d> found;
  for (const auto& triangle : mesh.triangles) {
    const std::uint32_t root = rootOf(triangle[0]);
    if (!seen[root]) found.push_back(mesh.vertices[root]);
    seen[root] = 1;
  }
  return found;
}

}  // namespace abstand::geometry
