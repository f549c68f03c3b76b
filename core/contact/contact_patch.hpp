// Polygons of a surface within an indentation, projected along the approach.
#pragma once

#include <array>

#include "core/contact/contact_area.hpp"

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
  std::vector<PatchPolygon> front;  ///< of the patch, facing the person
  std::vector<PatchPolygon> back;   ///< of the whole surface above the patch's lowest height, facing away
  double floor{0.0};                ///< m: depth = height - rho^2 / (2 body_radius) - floor
  double body_radius{kInfinity};
  Vector3d foremost_B{Vector3d::Zero()};
  double offset{0.0};
  double depth(const Vector3d& corner) const {
    return corner.z() - corner.head<2>().squaredNorm() / (2.0 * body_radius) - floor;
  }
};

/// The patch of `place` for an indentation x > 0 (m), which may be less than that of `place`.
ContactPatch contactPatch(const ContactSurface& surface, const ContactPlace& place, double x);

}  // namespace abstand::contact
