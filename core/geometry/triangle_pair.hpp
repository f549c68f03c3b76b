// Nearest points of two triangles.
#pragma once

#include <array>

#include "core/math/transform.hpp"

namespace abstand::geometry {

using TriangleCorners = std::array<Vector3d, 3>;

struct NearestPair {
  Vector3d on_a, on_b;
  double distance;  ///< m
};

/// Nearest points of two triangles that do not intersect: either both lie on edges, or one is a corner and
/// the other lies in a face. For intersecting triangles, the nearest of these pairs. Exact up to rounding if
/// edges are not shorter than 1e-9 of the coordinates. No allocation, no throw; pure.
NearestPair nearestPoints(const TriangleCorners& a, const TriangleCorners& b) noexcept;

}  // namespace abstand::geometry
