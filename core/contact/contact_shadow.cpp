#include "core/contact/contact_shadow.hpp"

#include <algorithm>

namespace abstand::contact {
namespace {

constexpr double kAbove = 1e-9;  // m: sheets that share an edge differ by rounding

struct Rectangle {
  Eigen::Vector2d lower{Eigen::Vector2d::Constant(kInfinity)}, upper{Eigen::Vector2d::Constant(-kInfinity)};
  explicit Rectangle(const PatchPolygon& polygon) {
    for (int i = 0; i < polygon.count; ++i) {
      lower = lower.cwiseMin(polygon.corner(i).head<2>());
      upper = upper.cwiseMax(polygon.corner(i).head<2>());
    }
  }
  bool overlaps(const Rectangle& other) const {
    return (lower.array() < other.upper.array()).all() && (other.lower.array() < upper.array()).all();
  }
};

/// Keeps what lies deeper than 0. Depth is concave over a piece, so the straight cut stays within.
PatchPolygon deepPart(const PatchTriangle& t, const ContactPatch& patch) {
  const std::array<double, 3> depths{patch.depth(t[0]), patch.depth(t[1]), patch.depth(t[2])};
  PatchPolygon polygon;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    const double da = depths[i], db = depths[next];
    if (da >= 0.0) polygon.add(t[i]);
    if ((da >= 0.0) != (db >= 0.0)) polygon.add(t[i] + da / (da - db) * (t[next] - t[i]));
  }
  return polygon;
}

PatchExtent extentOf(const PatchPolygon& polygon, const ContactPatch& patch) {
  PatchExtent extent;
  for (int i = 1; i + 1 < polygon.count; ++i) {
    const Vector3d &a = polygon.corner(0), &b = polygon.corner(i), &c = polygon.corner(i + 1);
    const double area = 0.5 * ((b - a).x() * (c - a).y() - (b - a).y() * (c - a).x());
    extent.area += area;
    // Depth is linear, or concave for a curved person: the mean over the corners is at most that over the
    // polygon.
    extent.volume += area * (patch.depth(a) + patch.depth(b) + patch.depth(c)) / 3.0;
  }
  return extent;
}

/// Twice the projected area of the triangle a, b, p: positive left of the edge from a to b.
double leftOf(const Vector3d& a, const Vector3d& b, const Vector3d& p) {
  return (b - a).x() * (p - a).y() - (b - a).y() * (p - a).x();
}

/// The part of `front` that overlaps the triangle `back`, which faces away, in projection.
PatchPolygon overlapOf(const PatchPolygon& front, const PatchPolygon& back) {
  PatchPolygon rest = front;
  for (int e = back.count; e > 0 && rest.count > 0; --e) {
    const Vector3d &a = back.corner(e), &b = back.corner(e - 1);
    const PatchPolygon whole = rest;
    rest.count = 0;
    for (int i = 0; i < whole.count; ++i) {
      const Vector3d &p = whole.corner(i), &q = whole.corner(i + 1);
      const double dp = leftOf(a, b, p), dq = leftOf(a, b, q);
      if (dp >= 0.0) rest.add(p);
      if ((dp >= 0.0) != (dq >= 0.0)) rest.add(p + dp / (dp - dq) * (q - p));
    }
  }
  return rest;
}

/// Height of the plane of a triangle at p.
double heightAt(const PatchPolygon& triangle, const Vector3d& p) {
  const Vector3d &a = triangle.corner(0), &b = triangle.corner(1), &c = triangle.corner(2);
  const double whole = leftOf(a, b, c), for_c = leftOf(a, b, p) / whole, for_b = leftOf(p, c, a) / whole;
  return a.z() + for_b * (b.z() - a.z()) + for_c * (c.z() - a.z());
}

bool isAbove(const PatchPolygon& back, const PatchPolygon& part_of_front) {
  for (int i = 0; i < part_of_front.count; ++i)
    if (heightAt(back, part_of_front.corner(i)) > part_of_front.corner(i).z() + kAbove) return true;
  return false;
}

}  // namespace

PatchExtent visibleExtent(const ContactPatch& patch) {
  std::vector<Rectangle> backs(patch.back.begin(), patch.back.end());
  PatchExtent sum;
  for (const PatchTriangle& piece : patch.pieces) {
    const PatchPolygon front = deepPart(piece, patch);
    if (front.count < 3 || !(front.area() > 0.0)) continue;
    ++sum.pieces;
    const Rectangle box(front);
    PatchExtent visible = extentOf(front, patch);
    for (std::size_t i = 0; i < backs.size(); ++i) {
      if (!box.overlaps(backs[i])) continue;
      const PatchPolygon overlap = overlapOf(front, patch.back[i]);
      if (overlap.count < 3 || !isAbove(patch.back[i], overlap)) continue;
      const PatchExtent hidden = extentOf(overlap, patch);
      visible.area -= hidden.area;
      visible.volume -= hidden.volume;
    }
    sum.area += std::max(0.0, visible.area);
    sum.volume += std::max(0.0, visible.volume);
  }
  return sum;
}

}  // namespace abstand::contact
