// Intersection test of two triangles of a mesh.
#include "core/geometry/mesh_surface_cut.hpp"

#include <algorithm>

namespace abstand::geometry {
namespace {

// Gaps below this share of the triangles' size count as contact.
constexpr double kTouch = 1e-9;

struct Span {
  double low, high;
};

Span span(const CutTriangle& t, const Vector3d& origin, const Vector3d& axis) {
  const double a = (t.corner[0] - origin).dot(axis), b = (t.corner[1] - origin).dot(axis),
               c = (t.corner[2] - origin).dot(axis);
  return {std::min({a, b, c}), std::max({a, b, c})};
}

double size(const CutTriangle& t) {
  return std::max((t.corner[1] - t.corner[0]).norm(), (t.corner[2] - t.corner[0]).norm());
}

// Separating axis test of two triangles: normals, cross products of edges, and in-plane normals of the edges
// (for coplanar triangles).
bool apart(const CutTriangle& s, const CutTriangle& t) {
  const Vector3d& origin = s.corner[0];
  const double touch = kTouch * std::max(size(s), size(t));
  const auto separates = [&](const Vector3d& axis) {
    const double length = axis.norm();
    const Span u = span(s, origin, axis), v = span(t, origin, axis);
    return u.low - v.high > touch * length || v.low - u.high > touch * length;
  };
  if (separates(s.normal) || separates(t.normal)) return true;
  for (int i = 0; i < 3; ++i) {
    const Vector3d e = s.corner[(i + 1) % 3] - s.corner[i];
    const Vector3d f = t.corner[(i + 1) % 3] - t.corner[i];
    if (separates(e.cross(s.normal)) || separates(f.cross(t.normal))) return true;
    for (int j = 0; j < 3; ++j) {
      if (separates(e.cross(t.corner[(j + 1) % 3] - t.corner[j]))) return true;
    }
  }
  return false;
}

// True if the open segment from p to q passes through the triangle, from one side of its plane to the other.
bool crosses(const Vector3d& p, const Vector3d& q, const CutTriangle& t) {
  const double touch = kTouch * std::max(size(t), (q - p).norm());
  const double dp = (p - t.corner[0]).dot(t.normal), dq = (q - t.corner[0]).dot(t.normal);
  if (!((dp > touch && dq < -touch) || (dp < -touch && dq > touch))) return false;
  const Vector3d x = p + (q - p) * (dp / (dp - dq));
  for (int i = 0; i < 3; ++i) {
    const Vector3d e = t.corner[(i + 1) % 3] - t.corner[i];
    if (e.cross(x - t.corner[i]).dot(t.normal) < 0.0) return false;
  }
  return true;
}

}  // namespace

bool cutEachOther(const CutTriangle& s, const CutTriangle& t) {
  int shared = 0, is = 0, it = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (s.vertex[i] == t.vertex[j]) ++shared, is = i, it = j;
    }
  }
  if (shared == 0) return !apart(s, t);
  if (shared > 1) return false;
  // Triangles that share one corner intersect along a line from it, which leaves one of them through the edge
  // opposite to the corner.
  return crosses(s.corner[(is + 1) % 3], s.corner[(is + 2) % 3], t) ||
         crosses(t.corner[(it + 1) % 3], t.corner[(it + 2) % 3], s);
}

}  // namespace abstand::geometry
