// Polygons of a surface within an indentation, projected along the approach.
#pragma once

#include <array>

#include "core/contact/contact_area.hpp"
#include "core/contact/curved_pieces.hpp"

namespace abstand::contact {

/// A convex polygon of a surface. Corners (m): u and v perpendicular to the approach, relative to the contact
/// point, and height along it. Counter-clockwise seen against the approach if it faces the person.
struct PatchPolygon {
  static constexpr int kMaxCorners = 8;
  std::array<Vector3d, kMaxCorners> corners;
  int count{0};

  void add(const Vector3d& c) {
    if (count < kMaxCorners) corners[static_cast<std::size_t>(count++)] = c;
  }
  const Vector3d& corner(int i) const { return corners[static_cast<std::size_t>(i % count)]; }
  /// Area (m^2) projected along the approach; negative if the polygon faces away.
  double area() const;
};

struct ContactPatch {
  std::vector<PatchTriangle> pieces;  ///< of the patch, some of them in part or wholly below depth 0
  /// Of the surface above the patch's lowest height, facing away: all that overlap a piece in projection.
  std::vector<PatchPolygon> back;
  double floor{0.0};  ///< m: depth = height - rho^2 / (2 body_radius) - floor
  double body_radius{kInfinity};
  Vector3d foremost_B{Vector3d::Zero()};
  double offset{0.0};
  double depth(const Vector3d& corner) const {
    return corner.z() - corner.head<2>().squaredNorm() / (2.0 * body_radius) - floor;
  }
};

/// The patch of `place` for an indentation x > 0 (m) that may be less than the place's own. It lives in
/// memory of the calling thread, until that thread calls again: patches are asked for thousands of times a
/// second.
const ContactPatch& contactPatch(const ContactSurface& surface, const ContactPlace& place, double x);

}  // namespace abstand::contact
