// Connected components of a mesh.
#pragma once

#include <vector>

#include "core/geometry/triangle_mesh.hpp"

namespace abstand::geometry {

/// One vertex of each component, in the order of the components' first triangles. Triangles that share a
/// vertex are connected.
std::vector<Vector3d> pieces(const TriangleMesh& mesh);

}  // namespace abstand::geometry
