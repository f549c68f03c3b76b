#include "core/contact/contact_patch.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::contact {
namespace {

using PatchTriangle = std::array<Vector3d, 3>;

// A triangle with edges up to l departs from a parabola of radius R by l^2 / (6 R) at most. Pieces of a
// curved patch are divided until l^2 <= kPieceShare R x, so that they depart by kPieceShare / 6 of x.
constexpr double kPieceShare = 0.1;
// More pieces than a sensible patch has (some hundred): nothing is certain then.
constexpr std::size_t kMaxPieces = 400'000;

/// The part of the surface above a height that is connected to a vertex.
struct Connected {
  std::vector<std::uint32_t> triangles;
  std::uint32_t foremost;
};

class PatchSearch {
 public:
  PatchSearch(const ContactSurface& surface, const ContactPlace& place, double x)
      : surface_{surface}, x_{x}, radius_{place.body_radius} {
    const Vector3d u_B = place.n_B.unitOrthogonal(), v_B = place.n_B.cross(u_B);
    Matrix3d R_PB;
    R_PB << u_B.transpose(), v_B.transpose(), place.n_B.transpose();
    points_.reserve(surface.mesh().vertices.size());
    for (const Vector3d& p_B : surface.mesh().vertices) points_.push_back(R_PB * (p_B - place.p_B));
    const ContactSurface::Nearest contact = surface.nearest(place.p_B);
    contact_height_ = place.n_B.dot(contact.point - place.p_B);
    start_ = *std::max_element(corners(contact.triangle).begin(), corners(contact.triangle).end(),
                               [&](std::uint32_t a, std::uint32_t b) { return height(a) < height(b); });
  }

  ContactPatch search() {
    Connected patch = connected(start_, contact_height_ - x_);
    const double top = height(patch.foremost);
    if (top > contact_height_) patch = connected(patch.foremost, top - x_);
    ContactPatch result;
    result.body_radius = radius_;
    result.foremost_B = surface_.mesh().vertices[patch.foremost];
    result.offset = top - contact_height_;
    std::vector<PatchTriangle> pieces;
    if (!divide(patch.triangles, pieces)) return result;
    result.floor = topOf(pieces, top) - x_;
    for (const PatchTriangle& piece : pieces) addFront(piece, result);
    addBacks(top - x_, result);
    return result;
  }

 private:
  const std::array<std::uint32_t, 3>& corners(std::uint32_t t) const { return surface_.mesh().triangles[t]; }
  double height(std::uint32_t vertex) const { return points_[vertex].z(); }
  PatchTriangle triangle(std::uint32_t t) const {
    return {points_[corners(t)[0]], points_[corners(t)[1]], points_[corners(t)[2]]};
  }
  double fallen(double rho2) const { return rho2 / (2.0 * radius_); }

  /// Vertices above `level` are connected where a triangle has both; a triangle belongs to any of its own.
  Connected connected(std::uint32_t start, double level) const {
    Connected found{{}, start};
    std::vector<char> seen(points_.size(), 0), taken(surface_.mesh().triangles.size(), 0);
    std::vector<std::uint32_t> open{start};
    seen[start] = 1;
    while (!open.empty()) {
      const std::uint32_t vertex = open.back();
      open.pop_back();
      if (height(vertex) > height(found.foremost)) found.foremost = vertex;
      for (const std::uint32_t t : surface_.around(vertex)) {
        if (taken[t]) continue;
        taken[t] = 1;
        found.triangles.push_back(t);
        for (const std::uint32_t next : corners(t))
          if (!seen[next] && height(next) >= level) {
            seen[next] = 1;
            open.push_back(next);
          }
      }
    }
    return found;
  }

  /// False where it takes too many pieces. Pieces that the curved body cannot reach are left out.
  bool divide(const std::vector<std::uint32_t>& triangles, std::vector<PatchTriangle>& pieces) const {
    const double longest2 = kPieceShare * radius_ * x_;
    std::vector<PatchTriangle> open;
    for (const std::uint32_t t : triangles) {
      open.push_back(triangle(t));
      while (!open.empty()) {
        const PatchTriangle piece = open.back();
        open.pop_back();
        if (outOfReach(piece)) continue;
        int longest = 0;
        double length2 = 0.0;
        for (int i = 0; i < 3; ++i) {
          const double l2 = (at(piece, i + 1) - at(piece, i)).head<2>().squaredNorm();
          if (l2 > length2) length2 = l2, longest = i;
        }
        if (length2 <= longest2) {
          pieces.push_back(piece);
          if (pieces.size() > kMaxPieces) return false;
          continue;
        }
        const Vector3d a = at(piece, longest), b = at(piece, longest + 1), c = at(piece, longest + 2);
        const Vector3d middle = 0.5 * (a + b);
        open.push_back({a, middle, c});
        open.push_back({middle, b, c});
      }
    }
    return true;
  }
  static const Vector3d& at(const PatchTriangle& t, int i) { return t[static_cast<std::size_t>(i % 3)]; }

  bool outOfReach(const PatchTriangle& t) const {
    if (std::isinf(radius_)) return false;
    const Vector3d centre = (t[0] + t[1] + t[2]) / 3.0;
    double extent = 0.0, top = -kInfinity;
    for (const Vector3d& c : t) {
      extent = std::max(extent, (c - centre).head<2>().norm());
      top = std::max(top, c.z());
    }
    const double rho = std::max(0.0, centre.head<2>().norm() - extent);
    return top - fallen(rho * rho) < contact_height_ - x_;
  }

  /// Not below the height of the foremost point of the body, seen from the curved person.
  double topOf(const std::vector<PatchTriangle>& pieces, double flat_top) const {
    if (std::isinf(radius_)) return flat_top;
    double top = contact_height_;
    for (const PatchTriangle& piece : pieces)
      for (const Vector3d& c : piece) top = std::max(top, c.z() - fallen(c.head<2>().squaredNorm()));
    return std::min(flat_top, top + kPieceShare / 6.0 * x_);
  }

  /// Keeps what lies deeper than 0. Depth is concave over a piece, so the straight cut stays within.
  static PatchPolygon deep(const PatchTriangle& t, const ContactPatch& patch) {
    PatchPolygon polygon;
    for (int i = 0; i < 3; ++i) {
      const Vector3d &a = at(t, i), &b = at(t, i + 1);
      const double da = patch.depth(a), db = patch.depth(b);
      if (da >= 0.0) polygon.add(a);
      if ((da >= 0.0) != (db >= 0.0)) polygon.add(a + da / (da - db) * (b - a));
    }
    return polygon;
  }

  static void addFront(const PatchTriangle& piece, ContactPatch& patch) {
    const PatchPolygon polygon = deep(piece, patch);
    if (polygon.count >= 3 && polygon.area() > 0.0) patch.front.push_back(polygon);
  }

  void addBacks(double level, ContactPatch& patch) const {
    for (std::uint32_t t = 0; t < surface_.mesh().triangles.size(); ++t) {
      const PatchTriangle c = triangle(t);
      if (std::max({c[0].z(), c[1].z(), c[2].z()}) < level) continue;
      PatchPolygon polygon;
      for (const Vector3d& corner : c) polygon.add(corner);
      if (polygon.area() < 0.0) patch.back.push_back(polygon);
    }
  }

  const ContactSurface& surface_;
  double x_, radius_;
  std::vector<Vector3d> points_;  ///< of the mesh: u, v, height
  double contact_height_{0.0};
  std::uint32_t start_{0};
};

}  // namespace

double PatchPolygon::area() const {
  double twice = 0.0;
  for (int i = 1; i + 1 < count; ++i) {
    const Vector3d a = corner(i) - corner(0), b = corner(i + 1) - corner(0);
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

ContactPatch contactPatch(const ContactSurface& surface, const ContactPlace& place, double x) {
  return PatchSearch(surface, place, x).search();
}

}  // namespace abstand::contact
