// Slow and simple geometry to compare with, and the shapes that the tests go through.
#pragma once

#include <algorithm>
#include <vector>

#include "core/geometry/shape.hpp"
#include "tests/support/random_pose.hpp"

namespace abstand::testing {

/// Nearest point of a triangle (Ericson, Real-Time Collision Detection, 5.1.5).
inline Vector3d nearestOfTriangle(const Vector3d& p, const Vector3d& a, const Vector3d& b,
                                  const Vector3d& c) {
  const Vector3d ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const Vector3d bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + d1 / (d1 - d3) * ab;
  const Vector3d cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  return a + (vb * ab + vc * ac) / (va + vb + vc);
}

inline double unsignedDistance(const geometry::TriangleMesh& mesh, const Vector3d& p) {
  double least = kInfinity;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    least = std::min(
        least, (p - nearestOfTriangle(p, mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2))).norm());
  return least;
}

/// Uniform in the cube [-reach, reach]^3.
inline Vector3d randomPoint(std::uint64_t seed, double reach) {
  Vector3d p;
  for (std::uint64_t i = 0; i < 3; ++i)
    p[static_cast<int>(i)] = reach * (2.0 * randomUnit(seed, 100 + i) - 1.0);
  return p;
}

inline std::vector<geometry::Shape> someShapes() {
  return {geometry::Sphere{0.05},
          geometry::Ellipsoid{{0.1, 0.1, 0.1}},
          geometry::Ellipsoid{{0.09, 0.12, 0.3}},
          geometry::Ellipsoid{{0.3, 0.3, 0.05}},
          geometry::Ellipsoid{{0.05, 0.4, 0.05}},
          geometry::Ellipsoid{{1.0, 0.01, 0.1}},
          geometry::Cuboid{{0.2, 0.3, 0.5}},
          geometry::Cylinder{0.05, 0.4},
          geometry::Cylinder{0.3, 0.02},
          geometry::Capsule{0.06, 0.3},
          geometry::Capsule{0.1, 0.0}};
}

/// Half the diagonal of the bounds: the size that tolerances are relative to.
inline double pairUncertainty(const geometry::Shape& shape) {
  return 0.5 * geometry::bounds(shape).extent().norm();
}

/// A function that is negative inside, zero on the surface and positive outside, of the order of 1.
inline double implicitValue(const geometry::Shape& shape, const Vector3d& p) {
  struct {
    Vector3d p;
    double operator()(const geometry::Sphere& s) const { return p.norm() / s.radius - 1; }
    double operator()(const geometry::Ellipsoid& s) const { return p.cwiseQuotient(s.semi_axes).norm() - 1; }
    double operator()(const geometry::Cuboid& s) const {
      return (2 * p.cwiseQuotient(s.size)).cwiseAbs().maxCoeff() - 1;
    }
    double operator()(const geometry::Cylinder& s) const {
      return std::max(std::hypot(p.x(), p.y()) / s.radius, std::abs(2 * p.z() / s.length)) - 1;
    }
    double operator()(const geometry::Capsule& s) const {
      const double beyond = std::max(0.0, std::abs(p.z()) - 0.5 * s.length);
      return std::hypot(p.x(), p.y(), beyond) / s.radius - 1;
    }
  } visitor{p};
  return std::visit(visitor, shape);
}

}  // namespace abstand::testing
