// The corners of a convex hull, side by side.
#pragma once

#include <vector>

#include "core/geometry/surface.hpp"

namespace abstand::structure {

/// The points at the corners of the hull; all of them where there is no telling, as of points in a plane.
std::vector<Vector3d> hullCorners(const std::vector<Vector3d>& points);

struct ExtremePoint {
  Vector3d point;                         ///< of the surface
  std::uint32_t hint{geometry::kNoHint};  ///< where on it that is
};

/// How far the hull of some points reaches in a direction, and where. Body frame, m. Constant after
/// construction; any number of threads; no allocation, no throw.
class HullPoints {
 public:
  HullPoints() = default;
  /// At least one corner, points of a surface. `centre`: about their middle, where rounding is smallest.
  HullPoints(const std::vector<Vector3d>& corners, const Vector3d& centre, const geometry::Surface& surface);

  const Vector3d& centre() const { return centre_; }
  /// Not below the largest g . p, and above it by rounding in float only; g of any length but 0.
  double reach(const Vector3d& g) const;
  /// The same about the centre.
  float reachAboutCentre(const Vector3f& g) const;
  /// The point that reaches farthest, to rounding in float.
  ExtremePoint extreme(const Vector3d& g) const;
  /// Both at once; the reach may be above the least by twice the rounding.
  double farthest(const Vector3d& g, ExtremePoint& extreme) const;
  std::size_t memoryBytes() const { return (3 * sizeof(float) + sizeof(std::uint32_t)) * x_.capacity(); }
  template <class Archive>
  void archive(Archive& ar) {
    ar(centre_, radius_, x_, y_, z_, hints_);
  }

 private:
  Vector3d centre_{Vector3d::Zero()};
  float radius_{0.0f};
  std::vector<float> x_, y_, z_;  ///< about the centre, padded to whole lanes with copies
  std::vector<std::uint32_t> hints_;
};

}  // namespace abstand::structure
