// Deep blocks of a near field: distances at their corners only.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.hpp"
#include "core/field/field_quanta.hpp"
#include "core/field/near_field.hpp"

namespace abstand::field {

// Computes the corners of deep blocks, row by row, so that the nearest triangle of the previous corner is a
// good hint.
void NearField::measureDeep(const geometry::Surface& surface, const BlockGrid& grid, double rounding,
                            int threads) {
  const Vector3i n = grid.size.array() + 1;
  const auto at = [&](int i, int j, int k) { return (std::size_t(k) * n.y() + j) * n.x() + i; };
  std::vector<float> distance(at(0, 0, n.z()), 0.0f);
  const auto wanted = [&](int i, int j, int k) {
    for (int c = 0; c < 8; ++c) {
      const Vector3i place(i - (c & 1), j - (c >> 1 & 1), k - (c >> 2));
      if ((place.array() < 0).any() || (place.array() >= grid.size.array()).any()) continue;
      if (block_index_[grid.indexOf(place)] == kDeepBlock) return true;
    }
    return false;
  };
  parallelFor(threads, std::size_t(n.y()) * n.z(), [&](std::size_t row) {
    const int j = static_cast<int>(row) % n.y(), k = static_cast<int>(row) / n.y();
    std::uint32_t hint = geometry::kNoHint;
    for (int i = 0; i < n.x(); ++i) {
      if (!wanted(i, j, k)) continue;
      const Vector3d p = grid.corner({i, j, k});
      const geometry::SurfacePoint nearest = surface.closest(p, hint);
      hint = nearest.hint;
      // For a watertight body all corners of deep blocks are inside.
      const bool inside = surface.watertight() || surface.inside(p, nearest);
      distance[at(i, j, k)] = static_cast<float>(inside ? -nearest.distance : nearest.distance);
    }
  });
  float largest = std::numeric_limits<float>::min();
  for (const float d : distance) largest = std::max(largest, std::abs(d));
  deep_quantum_ = largest / kMaxQuanta;
  deep_.resize(distance.size());
  std::transform(distance.begin(), distance.end(), deep_.begin(),
                 [&](float d) { return toQuanta(d, deep_quantum_); });
  deep_error_ =
      0.5 * kCubeDiagonal * kCells * grid.voxel + 0.5 * double(deep_quantum_) * kQuantized + rounding;
}

NearField::Cell NearField::deepCellOf(float px, float py, float pz) const {
  Cell cell;
  cell.values = nullptr;
  const float g[3] = {(px - ox_) * inv_h_, (py - oy_) * inv_h_, (pz - oz_) * inv_h_};
  std::size_t b[3];
  float t[3];
  for (int k = 0; k < 3; ++k) {
    // The negated form also rejects NaN.
    if (!(g[k] >= 0.0f && g[k] < cells_[k])) return cell;
    b[k] = static_cast<std::size_t>(g[k]) / kCells;
    t[k] = (g[k] - static_cast<float>(b[k] * kCells)) * (1.0f / kCells);
  }
  if (block_index_[(b[2] * static_cast<std::size_t>(blocks_[1]) + b[1]) *
                       static_cast<std::size_t>(blocks_[0]) +
                   b[0]] != kDeepBlock)
    return cell;
  cell.row = blocks_[0] + 1;
  cell.slice = cell.row * (blocks_[1] + 1);
  cell.values =
      &deep_[b[2] * static_cast<std::size_t>(cell.slice) + b[1] * static_cast<std::size_t>(cell.row) + b[0]];
  cell.x = t[0];
  cell.y = t[1];
  cell.z = t[2];
  cell.quantum = deep_quantum_;
  cell.inv_h = inv_h_ / kCells;
  return cell;
}

bool NearField::deep(float px, float py, float pz) const {
  return !deep_.empty() && deepCellOf(px, py, pz).values != nullptr;
}

}  // namespace abstand::field
