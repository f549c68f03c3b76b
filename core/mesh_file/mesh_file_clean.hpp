// Welded meshes without degenerate triangles; internal to mesh_file.cpp.
#pragma once

#include "core/geometry/triangle_mesh.hpp"

namespace abstand::mesh_file {

struct CleanMesh {
  geometry::TriangleMesh mesh;
  std::size_t degenerate{0};  ///< triangles of the input that collapsed or were flat
};

/// Welds within `tolerance` (m, positive) and drops triangles that are lower than it. Where such a flat
/// triangle joins two neighbours along its long side, the neighbour beyond that side is split at the
/// third corner instead of leaving a gap, so that closed meshes stay closed.
CleanMesh clean(const geometry::TriangleMesh& mesh, double tolerance);

}  // namespace abstand::mesh_file
