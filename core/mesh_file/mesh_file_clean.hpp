// Welding and removal of degenerate triangles; internal to mesh_file.cpp.
#pragma once

#include "core/geometry/triangle_mesh.hpp"

namespace abstand::mesh_file {

struct CleanMesh {
  geometry::TriangleMesh mesh;
  std::size_t degenerate{0};  ///< triangles of the input that collapsed or were flat
};

/// Welds vertices within `tolerance` (m, positive) and drops triangles whose height is below it. If such a
/// flat triangle connects two neighbours, the neighbour across its longest side is split at the third corner
/// instead of leaving a gap, so that closed meshes stay closed.
CleanMesh clean(const geometry::TriangleMesh& mesh, double tolerance);

}  // namespace abstand::mesh_file
