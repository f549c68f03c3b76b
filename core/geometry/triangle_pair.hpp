// The nearest points of two triangles.
#pragma once

#include <array>

#include "core/math/transform.hpp"

namespace abstand::geometry {

using TriangleCorners = std::array<Vector3d, 3>;

struct NearestPair {
  Vector3d on_a, on_b;
  double distance;  ///< m
};

/// The nearest points of two triangles that do not cut each other: each lies on an edge of one and an edge of
/// the other, or is a corner of one and lies in the other's face. Of triangles that cut each other, the
/// nearest pair of these. Exact to rounding where edges are not shorter than 1e-9 of the coordinates. No
/// allocation, no throw; pure.
NearestPair nearestPoints(const TriangleCorners& a, const TriangleCorners& b) noexcept;

}  // namespace abstand::geometry
