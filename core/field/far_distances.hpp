// Distances from the vertices of a grid to a mesh, from below.
#pragma once

#include <vector>

#include "core/geometry/triangle_mesh.hpp"

namespace abstand::field {

/// Points of a mesh from which distances to it follow: corners of its triangles, and of parts of these where
/// they are large. Let q be the nearest point of the surface to p. It is the foot of p on a part, an edge or
/// a corner of it, so |p - v|^2 = |p - q|^2 + |q - v|^2 for the corners v of that; and one of them is within
/// r of q, r being the largest distance in any part to its nearest corner. So
///   distance(p)^2 >= min_v |p - v|^2 - r^2,
/// and it is no less than that by more than r^2. Constant after construction.
class FarSites {
 public:
  /// `most`: r at most (m). No sites at all when there would be more than `max_sites`.
  FarSites(const geometry::TriangleMesh& mesh, const Vector3d& origin, double most, std::size_t max_sites);
  std::size_t size() const { return x_.size(); }

  /// Vertices p = origin + spacing (first + (i, j, k)), i < size.x and so on.
  struct Block {
    Vector3i first, size;
  };
  /// Sets values[i + row j + slice k] of a block to a distance that is never above the true one, and less by
  /// what was said above and by rounding in float. From one to the next vertex the difference of two squared
  /// distances is linear, so a site that is farther than another one at the middle of a block by more than
  /// the block is wide, times twice their distance, is the nearest for none of its vertices.
  void distances(const Block& block, double spacing, std::size_t row, std::size_t slice, float* values) const;

 private:
  struct List;
  struct Search;
  void find(Search& search, const Block& block, const List& list, float* values) const;

  std::vector<float> x_, y_, z_;  ///< about the origin
  double reach2_{0.0};            ///< r^2
  double radius2_{0.0};           ///< largest squared distance from the origin
};

}  // namespace abstand::field
