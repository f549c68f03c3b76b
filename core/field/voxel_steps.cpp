// Chessboard distances between voxels of a grid.
#include "core/field/voxel_steps.hpp"

#include <algorithm>

namespace abstand::field {

void countSteps(const Vector3i& size, int step, std::vector<std::int16_t>& steps) {
  const int nx = size.x(), ny = size.y(), nz = size.z();
  const auto next = [step](std::int16_t s) {
    return static_cast<std::int16_t>(std::min<int>(s + step, kMaxSteps));
  };
  const auto rowOf = [&](int j, int k) { return &steps[(std::size_t(k) * ny + j) * nx]; };
  // Minimum over three rows of neighbours, with a neutral element at each end.
  std::vector<std::int16_t> smallest(nx + 2, kMaxSteps);
  const auto sweepRow = [&](int j, int k, int direction) {
    std::fill(smallest.begin(), smallest.end(), kMaxSteps);
    const auto lower = [&](int jj, int kk) {
      if (jj < 0 || jj >= ny || kk < 0 || kk >= nz) return;
      const std::int16_t* row = rowOf(jj, kk);
      for (int i = 0; i < nx; ++i) smallest[i + 1] = std::min(smallest[i + 1], row[i]);
    };
    for (int dj = -1; dj <= 1; ++dj) lower(j + dj, k - direction);
    lower(j - direction, k);
    std::int16_t* row = rowOf(j, k);
    for (int i = 0; i < nx; ++i) {
      row[i] = std::min(row[i], next(std::min({smallest[i], smallest[i + 1], smallest[i + 2]})));
    }
    if (direction > 0) {
      for (int i = 1; i < nx; ++i) row[i] = std::min(row[i], next(row[i - 1]));
    } else {
      for (int i = nx - 2; i >= 0; --i) row[i] = std::min(row[i], next(row[i + 1]));
    }
  };
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) sweepRow(j, k, 1);
  }
  for (int k = nz - 1; k >= 0; --k) {
    for (int j = ny - 1; j >= 0; --j) sweepRow(j, k, -1);
  }
}

}  // namespace abstand::field
