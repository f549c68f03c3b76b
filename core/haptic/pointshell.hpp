// Points spread evenly over a surface.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/surface.hpp"

namespace abstand {

/// Structure of arrays in the body's frame (m). Point i has position, inward unit normal and the area (m^2)
/// that it stands for; the areas sum to the surface's area within 1 %. The order is such that the first m
/// points, for any m, are a uniform coarser shell (farthest-point order). Constant after construction.
struct Pointshell {
  std::vector<float> x, y, z;
  std::vector<float> nx, ny, nz;
  std::vector<float> area;
  double spacing{0.0};          ///< as asked for
  /// Certified: no point of the surface is farther than this from the nearest shell point.
  double covering_radius{0.0};

  std::size_t size() const { return x.size(); }
  Vector3d point(std::size_t i) const { return Vector3d(x[i], y[i], z[i]); }
  Vector3d normal(std::size_t i) const { return Vector3d(nx[i], ny[i], nz[i]); }
};

/// Samples uniformly with the pitch `spacing` (mean area per point about spacing^2), the same on every run.
Pointshell makePointshell(const Surface& surface, double spacing);

}  // namespace abstand
