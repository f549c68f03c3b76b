// How far a body reaches in a direction: the support function of its convex hull.
#pragma once

#include <optional>
#include <vector>

#include "core/geometry/surface.hpp"
#include "core/structure/hull_points.hpp"

namespace abstand::structure {

/// h(g) = max over the body of g . p, in the body's frame. It certifies distances from below, whatever the
/// shapes: for any unit vector g, no point of A is nearer to any of B than min_A g . p - max_B g . p.
///
/// Shapes are exact. Of a mesh, h is kept on a cube map of directions: h is convex and h(c g) = c h(g), so
/// with g = sum w_i g_i, w_i >= 0, h(g) <= sum w_i h(g_i): interpolating between the four corners of a cell
/// never gives too little. What it gives too much is below (1/32)^2 / 4 of the body's radius where the hull
/// is as round as a ball, and below 1/64 of the longest hull edge that the cell sees. Constant after
/// construction; any number of threads; no allocation, no throw.
class SupportMap {
 public:
  /// Along an edge of the cube.
  static constexpr int kCells = 32;

  SupportMap() = default;
  /// `mesh`: that of the surface; `centre`: about the middle of the body, where rounding is smallest.
  SupportMap(const geometry::Surface& surface, const geometry::TriangleMesh& mesh, const Vector3d& centre,
             int threads = 0);

  /// Archives hold no shapes: to be called after reading one.
  void setShape(const geometry::Surface& surface);

  /// Not below h(g), for finite g of any length but 0. m times the length of g.
  double upper(const Vector3d& g) const;
  /// The same, and above h(g) by rounding in float only: looks at every corner of the hull.
  double closeUpper(const Vector3d& g) const;
  /// A point of the surface that reaches as far along g, to rounding in float.
  ExtremePoint extreme(const Vector3d& g) const;
  /// closeUpper (but for a rounding more) and extreme at once.
  double farthest(const Vector3d& g, ExtremePoint& extreme) const;
  std::size_t memoryBytes() const { return sizeof(float) * values_.capacity() + hull_.memoryBytes(); }
  template <class Archive>
  void archive(Archive& ar) {
    ar(hull_, values_);
  }

 private:
  static constexpr int kCorners = kCells + 1;

  std::optional<geometry::Shape> shape_;
  HullPoints hull_;            ///< of a mesh
  std::vector<float> values_;  ///< of h about the centre; face (2 axis + side), v, u; rounded up
};

}  // namespace abstand::structure
