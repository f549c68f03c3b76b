// Points spread evenly over a surface.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/surface.hpp"

namespace abstand::shell {

/// Structure of arrays in the body's frame (m). Point i has position, inward unit normal and the area (m^2)
/// that it stands for. The areas of a shape sum to its area within 1e-6. A point of a mesh stands for the
/// magnitude of the summed area vectors of its piece of surface, so that they sum to a little less than the
/// mesh's area where it is bumpy (the bunny: 1 %). Faces that meet at a sharp edge are sampled apart, so that
/// a normal belongs to one face; elsewhere the normal is the exact one of a shape, or the mean over a mesh's
/// surface that the point stands for. Points and areas are such that sum_i a_i depth_i n_i over a half-space
/// is the overlapping volume times its normal: without bias in any orientation, and at edges and corners
/// within about 2 % from a depth of one spacing on (QuadratureCorrection). The order is such that the first m
/// points, for any m, are a uniform coarser shell (farthest-point order; the last few fill holes). Constant
/// after construction.
struct Pointshell {
  std::vector<float> x, y, z;
  std::vector<float> nx, ny, nz;
  std::vector<float> area;
  double spacing{0.0};  ///< as asked for
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

/// Samples uniformly with the pitch `spacing` (m), the same on every run: farthest-point sampling (Gonzalez
/// 1985; Eldar et al. 1997) of a fine subdivision, then one step of centring (Lloyd). The mean area per point
/// is about 2 / sqrt(3) spacing^2 on gently curved surfaces: 1,126 points for the thesis's sphere. Corners,
/// tips and strongly curved places get up to six times as many points per area and sharp edges twice as many,
/// so that a body may have up to about three quarters more. Runs on `threads` threads (0: all); the result
/// does not depend on the number. Throws UsageError for a spacing that is not positive or far too small for
/// the surface, and for a surface without area.
Pointshell makePointshell(const geometry::Surface& surface, double spacing, int threads = 1);

}  // namespace abstand::shell
