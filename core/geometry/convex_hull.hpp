// Convex hull of points.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::geometry {

/// As an intersection of half-spaces: p is inside where normal . p + offset <= 0 for all of them.
struct ConvexHull {
  Eigen::MatrixX4d planes;             ///< rows (outward unit normal, offset), m
  double volume{0.0};                  ///< m^3
  std::vector<std::uint32_t> corners;  ///< indices of the points that span it
  double farthest_outside{0.0};        ///< m, of a point; not 0 by rounding alone

  /// Distance from a point inside to the hull's surface (m); negative outside.
  double depth(const Vector3d& p) const { return -(planes * p.homogeneous()).maxCoeff(); }
};

/// By Qhull (Barber, Dobkin, Huhdanpaa 1996). Nothing for fewer than four points, and for points that lie in
/// a plane but for rounding.
std::optional<ConvexHull> convexHull(const std::vector<Vector3d>& points);

}  // namespace abstand::geometry
