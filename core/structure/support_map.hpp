// Support function of a body's convex hull.
#pragma once

#include <optional>
#include <vector>

#include "core/geometry/surface.hpp"
#include "core/structure/hull_points.hpp"

namespace abstand::structure {

/// h(g) = max over the body of g . p, in the body's frame. It gives a lower bound of distances for any
/// shapes: for any unit vector g, the distance of A and B is at least min_A g . p - max_B g . p.
///
/// Shapes are exact. For a mesh, h is stored on a cube map of directions. h is convex and h(c g) = c h(g), so
/// for g = sum w_i g_i, w_i >= 0, h(g) <= sum w_i h(g_i): interpolation between the four corners of a cell
/// never underestimates. It overestimates by less than (1/32)^2 / 4 of the body's radius where the hull is as
/// round as a sphere, and by less than 1/64 of the longest hull edge that the cell sees. Constant after
/// construction; any number of threads; no allocation, no throw.
class SupportMap {
 public:
  /// cells along an edge of the cube
  static constexpr int kCells = 32;

  SupportMap() = default;
  /// `mesh`: that of the surface; `centre`: near the middle of the body, which keeps rounding small.
  SupportMap(const geometry::Surface& surface, const geometry::TriangleMesh& mesh, const Vector3d& centre,
             int threads = 0);

  /// Sets the shape after reading an archive, which stores none.
  void setShape(const geometry::Surface& surface);

  /// Upper bound of h(g), for finite g of any length except 0. Unit: m times the length of g.
  double upper(const Vector3d& g) const;
  /// Upper bound of h(g) that exceeds it only by rounding in float: evaluates every vertex of the hull.
  double closeUpper(const Vector3d& g) const;
  /// A point of the surface with the largest g . p, up to rounding in float.
  ExtremePoint extreme(const Vector3d& g) const;
  /// closeUpper (with one more rounding) and extreme at once.
  double farthest(const Vector3d& g, ExtremePoint& extreme) const;
  std::size_t memoryBytes() const { return sizeof(float) * values_.capacity() + hull_.memoryBytes(); }
  template <class Archive>
  void archive(Archive& ar) {
    ar(hull_, values_);
  }

 private:
  static constexpr int kCorners = kCells + 1;

  std::optional<geometry::Shape> shape_;
  HullPoints hull_;            ///< for meshes
  std::vector<float> values_;  ///< h relative to the centre; index order face (2 axis + side), v, u; rounded
                               ///< up
};

}  // namespace abstand::structure
