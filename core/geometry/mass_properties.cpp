// Volume integrals over a triangle mesh.
#include "core/geometry/mass_properties.hpp"

#include <cmath>

namespace abstand::geometry {
namespace {

/// Below this share of (area)^(3/2) a volume is rounding noise of a flat mesh.
constexpr double kFlat = 1e-12;

}  // namespace

double signedVolume(const TriangleMesh& mesh) {
  if (mesh.vertices.empty()) return 0.0;
  const Vector3d centre = bounds(mesh).centre();
  double six = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vector3d a = mesh.corner(t, 0) - centre;
    const Vector3d b = mesh.corner(t, 1) - centre;
    const Vector3d c = mesh.corner(t, 2) - centre;
    six += a.dot(b.cross(c));
  }
  return six / 6.0;
}

MassProperties massProperties(const TriangleMesh& mesh) {
  MassProperties out;
  if (mesh.vertices.empty()) return out;
  const Bounds box = bounds(mesh);
  const Vector3d centre = box.centre();

  // Each triangle and the centre span a tetrahedron of signed volume det / 6. Its integrals of x and x x^T
  // are det / 24 (a + b + c) and det / 120 (a a^T + b b^T + c c^T + s s^T), s = a + b + c.
  double det_sum = 0.0;
  double area_sum = 0.0;
  Vector3d first = Vector3d::Zero();
  Vector3d area_moment = Vector3d::Zero();
  Matrix3d second = Matrix3d::Zero();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vector3d a = mesh.corner(t, 0) - centre;
    const Vector3d b = mesh.corner(t, 1) - centre;
    const Vector3d c = mesh.corner(t, 2) - centre;
    const Vector3d s = a + b + c;
    const double det = a.dot(b.cross(c));
    const double area = 0.5 * (b - a).cross(c - a).norm();
    det_sum += det;
    first += det * s;
    second += det * (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
    area_sum += area;
    area_moment += area / 3.0 * s;
  }

  const double volume = det_sum / 6.0;
  const Vector3d area_centre = area_sum > 0.0 ? Vector3d(area_moment / area_sum) : Vector3d::Zero().eval();
  out.com = centre + area_centre;
  if (!(volume > kFlat * area_sum * std::sqrt(area_sum))) return out;
  const Vector3d com = first / 24.0 / volume;
  if ((com.array().abs() > 0.5 * box.extent().array()).any()) return out;

  const Matrix3d covariance = second / 120.0 - volume * com * com.transpose();
  out.volume = volume;
  out.com = centre + com;
  out.inertia = covariance.trace() * Matrix3d::Identity() - covariance;
  return out;
}

}  // namespace abstand::geometry
