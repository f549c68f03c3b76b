// Connected pieces of a mesh.
#pragma once

#include <vector>

#include "core/geometry/triangle_mesh.hpp"

namespace abstand::geometry {

/// A vertex of each piece, in the order of the pieces' first triangles; triangles belong together when they
/// share a vertex.
std::vector<Vector3d> pieces(const TriangleMesh& mesh);

}  // namespace abstand::geometry
