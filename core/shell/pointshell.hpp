// Pointshell: points distributed evenly over a surface.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/surface.hpp"

namespace abstand::shell {

/// Structure of arrays in the body's frame (m). Point i has a position, an inward unit normal and the area
/// (m^2) that it represents. The areas of a shape sum to its area within 1e-6. A point of a mesh has the
/// magnitude of the summed area vectors of its patch of surface, so that on bumpy meshes the sum is slightly
/// below the mesh's area (bunny: 1 %). Faces that meet at a sharp edge are sampled separately, so that a
/// normal belongs to one face; elsewhere the normal is the exact one of a shape, or the mean over the patch
/// of a mesh. Points and areas are adjusted (QuadratureCorrection) so that sum_i a_i depth_i n_i over a
/// half-space is the overlapping volume times its normal: unbiased in any orientation, and at edges and
/// corners within about 2 % for depths of at least one spacing. Points are in farthest-point order: for any
/// m, the first m points are a uniform coarser shell (the last few points fill holes). Constant after
/// construction.
struct Pointshell {
  std::vector<float> x, y, z;
  std::vector<float> nx, ny, nz;
  std::vector<float> area;
  double spacing{0.0};  ///< requested
  /// Certified: no point of the surface is farther than this from the nearest shell point.
  double covering_radius{0.0};

  std::size_t size() const { return x.size(); }
  Vector3d point(std::size_t i) const { return Vector3d(x[i], y[i], z[i]); }
  Vector3d normal(std::size_t i) const { return Vector3d(nx[i], ny[i], nz[i]); }
  template <class Archive>
  void archive(Archive& ar) {
    ar(x, y, z, nx, ny, nz, area, spacing, covering_radius);
  }
};

/// Samples uniformly with the pitch `spacing` (m), deterministically: farthest-point sampling (Gonzalez 1985;
/// Eldar et al. 1997) of a fine subdivision, then one step of Lloyd relaxation. The mean area of a point on
/// gently curved surfaces is about 2 / sqrt(3) spacing^2: 1,126 points for the thesis's sphere. Corners, tips
/// and strongly curved places get up to six times as many points per area and sharp edges twice as many, but
/// a body at most 60 % more. Uses `threads` threads (0: all); the result does not depend on
/// their number. Throws UsageError for a spacing that is not positive or far too small for the surface, and
/// for a surface without area.
Pointshell makePointshell(const geometry::Surface& surface, double spacing, int threads = 1);

}  // namespace abstand::shell
