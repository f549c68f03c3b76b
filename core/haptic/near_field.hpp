// Signed float distances about the surface.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/surface.hpp"
#include "core/haptic/grid.hpp"

namespace abstand {

/// Signed distances (positive outside) at the corners of a grid's voxels, in blocks of 8 x 8 x 8 voxels (9^3
/// vertices, so that a sample never leaves its block). Dense: every block of the grid is there. Sparse: only
/// blocks that come within the band of the surface, and the blocks inside the body. Trilinear between
/// vertices. Constant after construction; samples may be taken on any number of threads.
class NearField {
 public:
  static constexpr int kCells = 8;
  static constexpr int kVertices = kCells + 1;
  static constexpr int kBlockValues = kVertices * kVertices * kVertices;
  static constexpr std::uint32_t kNoBlock = 0xffffffffu;

  NearField() = default;
  /// `band` (m): outside the body, blocks farther than this from the surface are left out; infinity: dense.
  /// Throws UsageError when the blocks would take more than 2 GB.
  NearField(const Surface& surface, const VoxelGrid& grid, double band, int threads = 0);

  /// Trilinear signed distance (m) and its gradient (unit-less, not normalised). False when p lies in no
  /// block, and for NaN and infinity; then nothing is written.
  bool sample(float px, float py, float pz, float& distance) const;
  bool sampleGradient(float px, float py, float pz, float& distance, float gradient[3]) const;

  /// Certified for every p with sample() true: |sample - true signed distance| <= errorBound(). It is
  /// sqrt(3)/2 voxels and float rounding: for a 1-Lipschitz function the error is at most sum_i w_i |p -
  /// v_i|, and that at most the root of sum_i w_i |p - v_i|^2 = sum_axes h^2 t (1 - t) <= 3 h^2 / 4 (Jensen).
  /// Where a mesh is not watertight the signed distance jumps across its holes; there it is certain only that
  /// a sample does not exceed the unsigned distance by more than the bound.
  double errorBound() const { return error_bound_; }
  /// Where sample() is false, the surface is farther than this (m).
  double band() const { return band_; }
  std::size_t memoryBytes() const;
  std::size_t blocks() const { return values_.size() / kBlockValues; }
  const VoxelGrid& grid() const { return grid_; }
  template <class Archive>
  void archive(Archive& ar) {
    ar(grid_, ox_, oy_, oz_, inv_h_, cells_, blocks_, block_index_, values_, error_bound_, band_);
  }

 private:
  /// The values at a cell's first corner, and where p lies in the cell (0 to 1). Null outside.
  const float* cellOf(float px, float py, float pz, float& x, float& y, float& z) const {
    const float gx = (px - ox_) * inv_h_, gy = (py - oy_) * inv_h_, gz = (pz - oz_) * inv_h_;
    // Written so that NaN fails.
    if (!(gx >= 0.0f && gy >= 0.0f && gz >= 0.0f && gx < cells_[0] && gy < cells_[1] && gz < cells_[2])) {
      return nullptr;
    }
    const unsigned i = static_cast<int>(gx), j = static_cast<int>(gy), k = static_cast<int>(gz);
    const std::uint32_t block =
        block_index_[(std::size_t(k / kCells) * blocks_[1] + j / kCells) * blocks_[0] + i / kCells];
    if (block == kNoBlock) return nullptr;
    x = gx - static_cast<float>(static_cast<int>(i));
    y = gy - static_cast<float>(static_cast<int>(j));
    z = gz - static_cast<float>(static_cast<int>(k));
    return &values_[std::size_t(block) * kBlockValues + ((k % kCells) * kVertices + j % kCells) * kVertices +
                    i % kCells];
  }

  VoxelGrid grid_;
  float ox_{0}, oy_{0}, oz_{0}, inv_h_{0};
  float cells_[3]{0, 0, 0};  ///< of all blocks
  int blocks_[3]{0, 0, 0};
  std::vector<std::uint32_t> block_index_;
  std::vector<float> values_;  ///< 729 a block
  double error_bound_{0.0};
  double band_{0.0};
};

inline bool NearField::sample(float px, float py, float pz, float& distance) const {
  float x, y, z;
  const float* v = cellOf(px, py, pz, x, y, z);
  if (!v) return false;
  constexpr int kRow = kVertices, kSlice = kVertices * kVertices;
  const auto along = [x](const float* p) { return p[0] + x * (p[1] - p[0]); };
  const float a = along(v), b = along(v + kRow), c = along(v + kSlice), d = along(v + kSlice + kRow);
  const float near = a + y * (b - a), far = c + y * (d - c);
  distance = near + z * (far - near);
  return true;
}

}  // namespace abstand
