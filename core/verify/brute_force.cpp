// Exact distances over all pairs of triangles. Shares no code with the engine under test.
#include "core/verify/brute_force.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace abstand::verify {
namespace {

// Share of the squared lengths: below this two segments count as parallel, and their end points decide. The
// error is at most 1e-12 of a length.
constexpr double kParallel = 1e-24;
// Spheres are enlarged by this factor, so that rounding never skips a triangle.
constexpr double kLarger = 1.0 + 1e-12;
// Share of the largest coordinate: rounding of transformed corners and of their differences.
constexpr double kCoordinatePart = 4e-15;

/// Six times the signed volume of the tetrahedron: its sign tells on which side of the triangle a, b, c the
/// point d lies.
double side(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
  return (b - a).cross(c - a).dot(d - a);
}

/// The same, but 0 if rounding could decide the sign: an edge in the triangle's plane, or a degenerate
/// triangle. Then the distances of corners and edges suffice.
double certainSide(const Triangle& t, const Vector3d& p) {
  const double u = (t[1] - t[0]).norm(), v = (t[2] - t[0]).norm(), w = (p - t[0]).norm();
  const double largest = std::max({t[0].cwiseAbs().maxCoeff(), t[1].cwiseAbs().maxCoeff(),
                                   t[2].cwiseAbs().maxCoeff(), p.cwiseAbs().maxCoeff()});
  const double volume = side(t[0], t[1], t[2], p);
  return std::abs(volume) > kCoordinatePart * largest * (u * v + v * w + w * u) ? volume : 0.0;
}

bool cuts(const Vector3d& p, const Vector3d& q, const Triangle& t) {
  const double over = certainSide(t, p), under = certainSide(t, q);
  if (!((over > 0.0 && under < 0.0) || (over < 0.0 && under > 0.0))) return false;
  const double u = side(p, q, t[0], t[1]), v = side(p, q, t[1], t[2]), w = side(p, q, t[2], t[0]);
  return (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
}

}  // namespace

double distancePointSegment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const Vector3d along = b - a;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (p - (a + t * along)).norm();
}

double distanceSegments(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
  // The nearest points are an end of one segment, or interior to both on their common normal.
  double smallest = std::min({distancePointSegment(a, c, d), distancePointSegment(b, c, d),
                              distancePointSegment(c, a, b), distancePointSegment(d, a, b)});
  const Vector3d u = b - a, v = d - c, w = c - a, n = u.cross(v);
  const double n2 = n.squaredNorm();
  if (n2 > kParallel * u.squaredNorm() * v.squaredNorm()) {
    const double s = w.cross(v).dot(n) / n2, t = w.cross(u).dot(n) / n2;
    if (s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0) smallest = std::min(smallest, (w + t * v - s * u).norm());
  }
  return smallest;
}

double distancePointTriangle(const Vector3d& p, const Triangle& t) {
  double smallest = std::min({distancePointSegment(p, t[0], t[1]), distancePointSegment(p, t[1], t[2]),
                              distancePointSegment(p, t[2], t[0])});
  const Vector3d n = (t[1] - t[0]).cross(t[2] - t[0]);
  const double n2 = n.squaredNorm();
  if (n2 > 0.0) {
    const Vector3d foot = p - n * (n.dot(p - t[0]) / n2);
    const auto left = [&](int i) { return n.dot((t[(i + 1) % 3] - t[i]).cross(foot - t[i])) >= 0.0; };
    if (left(0) && left(1) && left(2)) smallest = std::min(smallest, (p - foot).norm());
  }
  return smallest;
}

double distanceTriangles(const Triangle& s, const Triangle& t) {
  double smallest = kInfinity;
  for (int i = 0; i < 3; ++i) {
    const Vector3d &a = s[i], &b = s[(i + 1) % 3], &c = t[i], &d = t[(i + 1) % 3];
    if (cuts(a, b, t) || cuts(c, d, s)) return 0.0;
    smallest = std::min({smallest, distancePointTriangle(a, t), distancePointTriangle(c, s)});
    for (int j = 0; j < 3; ++j) smallest = std::min(smallest, distanceSegments(a, b, t[j], t[(j + 1) % 3]));
  }
  return smallest;
}

TriangleSoup::TriangleSoup(const geometry::TriangleMesh& mesh) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    add({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)});
  // Components: smallest vertex index among connected vertices, iterated until nothing changes.
  std::vector<std::uint32_t> piece(mesh.vertices.size());
  std::iota(piece.begin(), piece.end(), 0u);
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& t : mesh.triangles) {
      const std::uint32_t lowest = std::min({piece[t[0]], piece[t[1]], piece[t[2]]});
      for (const std::uint32_t v : t) {
        changed = changed || piece[v] != lowest;
        piece[v] = lowest;
      }
    }
  }
  std::vector<char> used(mesh.vertices.size(), 0);
  for (const auto& t : mesh.triangles) {
    if (used[piece[t[0]]]) continue;
    used[piece[t[0]]] = 1;
    probes_.push_back(mesh.vertices[t[0]]);
  }
}

void TriangleSoup::add(const Triangle& t) {
  triangles_.push_back(t);
  const Vector3d centre = (t[0] + t[1] + t[2]) / 3.0;
  const double radius =
      std::max({(t[0] - centre).norm(), (t[1] - centre).norm(), (t[2] - centre).norm()}) * kLarger;
  balls_.push_back({centre, radius});
}

TriangleSoup TriangleSoup::moved(const Transform& X) const {
  TriangleSoup out;
  out.triangles_.reserve(size());
  out.balls_.reserve(size());
  for (const Triangle& t : triangles_) out.add({X * t[0], X * t[1], X * t[2]});
  for (const Vector3d& p : probes_) out.probes_.push_back(X * p);
  return out;
}

double TriangleSoup::distanceTo(const Vector3d& p) const {
  double smallest = kInfinity;
  for (std::size_t i = 0; i < size(); ++i) {
    const double reach = smallest + balls_[i].radius;
    if ((balls_[i].centre - p).squaredNorm() <= reach * reach)
      smallest = std::min(smallest, distancePointTriangle(p, triangles_[i]));
  }
  return smallest;
}

double TriangleSoup::distanceTo(const TriangleSoup& other) const {
  double smallest = kInfinity;
  for (std::size_t i = 0; i < size(); ++i) {
    for (std::size_t j = 0; j < other.size(); ++j) {
      const double reach = (smallest + balls_[i].radius + other.balls_[j].radius) * kLarger;
      if ((balls_[i].centre - other.balls_[j].centre).squaredNorm() > reach * reach) continue;
      smallest = std::min(smallest, distanceTriangles(triangles_[i], other.triangles_[j]));
      if (smallest == 0.0) return 0.0;
    }
  }
  return smallest;
}

double TriangleSoup::windingNumber(const Vector3d& p) const {
  double angle = 0.0;
  for (const Triangle& t : triangles_) {
    const Vector3d a = t[0] - p, b = t[1] - p, c = t[2] - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    const double up = a.cross(b).dot(c);
    const double down = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    angle += 2.0 * std::atan2(up, down);
  }
  return angle / (4.0 * kPi);
}

}  // namespace abstand::verify
