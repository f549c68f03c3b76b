// Vertices of a convex hull as a structure of arrays, with its support function.
#pragma once

#include <vector>

#include "core/geometry/surface.hpp"

namespace abstand::structure {

/// The vertices of the hull; all points if there is no hull, as for coplanar points.
std::vector<Vector3d> hullCorners(const std::vector<Vector3d>& points);

struct ExtremePoint {
  Vector3d point;                         ///< on the surface
  std::uint32_t hint{geometry::kNoHint};  ///< its location on the surface
};

/// Support function of the convex hull of points. Body frame, m. Constant after construction; any number of
/// threads; no allocation, no throw.
class HullPoints {
 public:
  HullPoints() = default;
  /// At least one corner; corners lie on `surface`. `centre`: near their middle, which keeps rounding small.
  HullPoints(const std::vector<Vector3d>& corners, const Vector3d& centre, const geometry::Surface& surface);

  const Vector3d& centre() const { return centre_; }
  /// Upper bound of max g . p, exceeding it only by rounding in float; g of any length except 0.
  double support(const Vector3d& g) const;
  /// The same relative to the centre.
  float supportAboutCentre(const Vector3f& g) const;
  /// The point with the largest g . p, up to rounding in float.
  ExtremePoint extreme(const Vector3d& g) const;
  /// Both at once; the result may exceed the maximum by twice the rounding.
  double farthest(const Vector3d& g, ExtremePoint& extreme) const;
  std::size_t memoryBytes() const { return (3 * sizeof(float) + sizeof(std::uint32_t)) * x_.capacity(); }
  template <class Archive>
  void archive(Archive& ar) {
    ar(centre_, radius_, x_, y_, z_, hints_);
  }

 private:
  Vector3d centre_{Vector3d::Zero()};
  float radius_{0.0f};
  std::vector<float> x_, y_, z_;  ///< relative to the centre, padded to whole lanes with copies
  std::vector<std::uint32_t> hints_;
};

}  // namespace abstand::structure
