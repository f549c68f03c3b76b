// Lofted closed meshes through cross-sections.
#pragma once

#include <span>

#include "core/geometry/triangle_mesh.hpp"

namespace abstand::tracking {

/// A superelliptic cross-section: the points centre + u a cos^(2/n) + v b sin^(2/n), an ellipse for n = 2 and
/// closer to a rectangle for larger n. `u` and `v` are perpendicular unit vectors; u x v points to the next
/// section.
struct LoftSection {
  Vector3d centre, u, v;
  double a{0.0}, b{0.0};  ///< m, half extents along u and v
  double n{2.0};
};

/// Bands between neighbours and a fan at each end: closed, triangles outward as long as no section intersects
/// its neighbour. At least two sections.
geometry::TriangleMesh loft(std::span<const LoftSection> sections);

/// Monotone cubic interpolation (Fritsch, Butland 1984) at `x` through (x, y) pairs with increasing x;
/// constant beyond both ends. Values stay within the range of the two neighbours.
struct CurvePoint {
  double x, y;
};
double smoothCurve(std::span<const CurvePoint> points, double x);

}  // namespace abstand::tracking
