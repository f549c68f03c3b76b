// Smallest sphere about a set of points.
#pragma once

#include <vector>

#include "core/math/transform.hpp"

namespace abstand::geometry {

/// Centre and radius (m).
struct EnclosingSphere {
  Vector3d centre{Vector3d::Zero()};
  double radius{0.0};
};

/// Minimal enclosing sphere, by pivoting on the farthest point (Gaertner 1999, Fast and Robust Smallest
/// Enclosing Balls). Every point is within the radius, to the last bit of |p - centre|; the radius is minimal
/// within about 1e-12 of itself. No points: radius 0 about the origin.
EnclosingSphere minimalSphere(const std::vector<Vector3d>& points);

}  // namespace abstand::geometry
