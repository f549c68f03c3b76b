// The nearest points of two triangles.
#include "core/geometry/triangle_pair.hpp"

#include <algorithm>

namespace abstand::geometry {
namespace {

struct Best {
  Vector3d on_a, on_b;
  double d2{kInfinity};
  void update(const Vector3d& p, const Vector3d& q) {
    const double candidate = (p - q).squaredNorm();
    if (candidate < d2) on_a = p, on_b = q, d2 = candidate;
  }
};

double unitInterval(double t) { return std::min(std::max(t, 0.0), 1.0); }

/// Nearest points of p + s u and q + t v, s and t in [0, 1] (Ericson, Real-Time Collision Detection, 5.1.9).
void segments(const Vector3d& p, const Vector3d& u, const Vector3d& q, const Vector3d& v, Best& best) {
  const Vector3d r = p - q;
  const double a = u.squaredNorm(), e = v.squaredNorm(), f = v.dot(r), c = u.dot(r), b = u.dot(v);
  const double across = a * e - b * b;
  // For parallel segments any s is valid.
  const double s = across > 0.0 ? unitInterval((b * f - c * e) / across) : 0.0;
  const double t = unitInterval((b * s + f) / e);
  best.update(p + unitInterval((b * t - c) / a) * u, q + t * v);
}

/// Pair of the corner p and its projection onto the face of t, if it lies in the face.
void corner(const Vector3d& p, const TriangleCorners& t, const Vector3d (&edge)[3], const Vector3d& normal,
            bool p_is_of_a, Best& best) {
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (edge[i].cross(p - t[k]).dot(normal) < 0.0) return;
  }
  const Vector3d q = p - normal * (normal.dot(p - t[0]) / normal.squaredNorm());
  p_is_of_a ? best.update(p, q) : best.update(q, p);
}

}  // namespace

NearestPair nearestPoints(const TriangleCorners& a, const TriangleCorners& b) noexcept {
  const Vector3d edge_a[3] = {a[1] - a[0], a[2] - a[1], a[0] - a[2]};
  const Vector3d edge_b[3] = {b[1] - b[0], b[2] - b[1], b[0] - b[2]};
  const Vector3d normal_a = edge_a[0].cross(edge_a[1]), normal_b = edge_b[0].cross(edge_b[1]);
  Best best;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) segments(a[i], edge_a[i], b[j], edge_b[j], best);
    corner(a[i], b, edge_b, normal_b, true, best);
    corner(b[i], a, edge_a, normal_a, false, best);
  }
  return {best.on_a, best.on_b, std::sqrt(best.d2)};
}

}  // namespace abstand::geometry
