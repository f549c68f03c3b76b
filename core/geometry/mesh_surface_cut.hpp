// Whether two triangles of a mesh cut each other.
#pragma once

#include "core/geometry/triangle_mesh.hpp"

namespace abstand::geometry {

struct CutTriangle {
  std::array<std::uint32_t, 3> vertex;
  std::array<Vector3d, 3> corner;
  Vector3d normal;  ///< unit
};

/// True when the triangles have points in common other than shared vertices and edges. Touching counts for
/// triangles that share no vertex; of those that share one only true crossing does; two that share an edge
/// never cut each other.
bool cutEachOther(const CutTriangle& s, const CutTriangle& t);

}  // namespace abstand::geometry
