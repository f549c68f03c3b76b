// Intersection test of two triangles of a mesh.
#pragma once

#include "core/geometry/triangle_mesh.hpp"

namespace abstand::geometry {

struct CutTriangle {
  std::array<std::uint32_t, 3> vertex;
  std::array<Vector3d, 3> corner;
  Vector3d normal;  ///< unit
};

/// True if the triangles have common points other than shared vertices and edges. Touching counts for
/// triangles without a shared vertex; with one shared vertex, only a proper crossing counts; with a shared
/// edge, never.
bool cutEachOther(const CutTriangle& s, const CutTriangle& t);

}  // namespace abstand::geometry
