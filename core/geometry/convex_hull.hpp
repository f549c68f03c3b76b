// Convex hull of points.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::geometry {

/// Intersection of half-spaces: p is inside if normal . p + offset <= 0 for all of them.
struct ConvexHull {
  Eigen::MatrixX4d planes;             ///< rows (outward unit normal, offset), m
  double volume{0.0};                  ///< m^3
  std::vector<std::uint32_t> corners;  ///< indices of the points that are vertices of the hull
  double farthest_outside{0.0};        ///< largest distance of an input point outside of the hull, m; above 0
                                       ///< only by rounding

  /// Distance from a point inside to the hull's surface (m); negative outside.
  double depth(const Vector3d& p) const { return -(planes * p.homogeneous()).maxCoeff(); }
};

/// Convex hull by Qhull (Barber, Dobkin, Huhdanpaa 1996). nullopt for fewer than four points and for points
/// that are coplanar up to rounding.
std::optional<ConvexHull> convexHull(const std::vector<Vector3d>& points);

}  // namespace abstand::geometry
