// Closed meshes through a row of cross-sections.
#pragma once

#include <span>

#include "core/geometry/triangle_mesh.hpp"

namespace abstand::tracking {

/// A rounded cross-section: the points centre + u a cos^(2/n) + v b sin^(2/n), an ellipse for n = 2 and
/// nearer to its rectangle for greater n. `u` and `v` are square to each other, of length 1; u x v points to
/// the next section.
struct LoftSection {
  Vector3d centre, u, v;
  double a{0.0}, b{0.0};  ///< m, half the extents along u and v
  double n{2.0};
};

/// Bands between neighbours and a fan over each end: closed, triangles outwards as long as no section bends
/// through its neighbour. At least two sections.
geometry::TriangleMesh loft(std::span<const LoftSection> sections);

/// The value at `x` of a smooth curve through (x, y) pairs whose x rises; constant beyond both ends. No value
/// leaves the range of the two neighbours (monotone cubic; Fritsch, Butland 1984).
struct CurvePoint {
  double x, y;
};
double smoothCurve(std::span<const CurvePoint> points, double x);

}  // namespace abstand::tracking
