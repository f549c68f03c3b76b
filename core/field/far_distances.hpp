// Lower bounds of the distances from grid vertices to a mesh.
#pragma once

#include <vector>

#include "core/geometry/triangle_mesh.hpp"

namespace abstand::field {

/// Points (sites) of a mesh from which lower bounds of distances follow: the corners of its triangles, large
/// triangles being subdivided. Let q be the nearest surface point to p. It is the foot of the perpendicular
/// from p on a triangle, an edge or a corner, so |p - v|^2 = |p - q|^2 + |q - v|^2 for the corners v of that
/// feature; one of them is within r of q, where r is the largest distance from a point of a triangle to its
/// nearest corner. So
///   distance(p)^2 >= min_v |p - v|^2 - r^2,
/// and the right side is too small by at most r^2. Constant after construction.
class FarSites {
 public:
  /// `max_distance`: upper limit of r (m). Empty if more than `max_sites` sites would be needed.
  FarSites(const geometry::TriangleMesh& mesh, const Vector3d& origin, double max_distance,
           std::size_t max_sites);
  std::size_t size() const { return x_.size(); }

  /// Vertices p = origin + spacing (first + (i, j, k)), i < size.x and so on.
  struct Block {
    Vector3i first, size;
  };
  /// Sets values[i + row j + slice k] to a lower bound of the distance (m), too small by at most r^2 in the
  /// square and by rounding in float. The difference of two squared distances is linear in p, so a site is
  /// nearest to no vertex of a block if at the block's middle its squared distance exceeds that of another
  /// site by more than the block's diameter times the distance of the two sites.
  void distances(const Block& block, double spacing, std::size_t row, std::size_t slice, float* values) const;

 private:
  struct List;
  struct Search;
  void find(Search& search, const Block& block, const List& list, float* values) const;

  std::vector<float> x_, y_, z_;  ///< relative to the origin
  double reach2_{0.0};            ///< r^2
  double radius2_{0.0};           ///< largest squared distance from the origin
};

}  // namespace abstand::field
