// Subsampled points of a depth image on a grid.
#pragma once

#include <vector>

#include "core/math/transform.hpp"

namespace abstand::tracking {

/// Points of an image (m, camera's frame), row by row; 0 without measurement.
struct PointGrid {
  int columns{0}, rows{0};
  std::vector<Vector3d> points;

  int indexOf(int column, int row) const { return row * columns + column; }
};

}  // namespace abstand::tracking
