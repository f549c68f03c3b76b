// Quality report of a mesh.
#pragma once

#include <string>
#include <vector>

#include "core/geometry/triangle_mesh.hpp"

namespace abstand::mesh_file {

struct MeshReport {
  std::size_t triangles{0};
  std::size_t vertices{0};
  std::size_t open_edges{0};            ///< edges with one triangle
  std::size_t non_manifold_edges{0};    ///< edges with more than two triangles
  std::size_t flipped_edges{0};         ///< edges whose two triangles have the same direction
  std::size_t degenerate_triangles{0};  ///< dropped when reading: zero area or a repeated vertex
  std::size_t components{0};            ///< components connected by edges
  double volume{0.0};                   ///< signed, m^3
  Vector3d extent{Vector3d::Zero()};    ///< m
  bool watertight{false};               ///< no open, non-manifold or flipped edge, and a positive volume
  std::vector<std::string> remarks;     ///< plain sentences: open edges, unit doubts, inverted mesh ...
};

/// `mesh` is welded already; degenerate_triangles stays 0 (only the reader knows it).
MeshReport inspect(const geometry::TriangleMesh& mesh);

}  // namespace abstand::mesh_file
