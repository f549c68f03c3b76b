// Signed float distances about the surface.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/surface.hpp"
#include "core/haptic/grid.hpp"

namespace abstand {

/// Signed distances (positive outside) at grid vertices, in blocks of 8 x 8 x 8 cells (9^3 vertices, so that
/// a sample never leaves its block). Dense: every block of the grid is there. Sparse: only blocks that come
/// within the band of the surface, and the blocks inside the body. Trilinear between vertices. Constant after
/// construction.
class NearField {
 public:
  static constexpr int kCells = 8;
  static constexpr int kVertices = kCells + 1;
  static constexpr std::uint32_t kNoBlock = 0xffffffffu;

  NearField() = default;
  /// `band` (m): outside the body, blocks farther than this from the surface are left out; infinity: dense.
  NearField(const Surface& surface, const VoxelGrid& grid, double band, int threads = 0);

  /// Trilinear signed distance. False, and `distance` untouched, when p lies in no block or is not finite.
  bool sample(float px, float py, float pz, float& distance) const;

  /// Certified for every p with sample() true: |sample - true signed distance| <= errorBound(), sqrt(3)/2
  /// voxels and rounding, as for any 1-Lipschitz function.
  double errorBound() const { return error_bound_; }
  double band() const { return band_; }
  std::size_t memoryBytes() const;
  const VoxelGrid& grid() const { return grid_; }

 private:
  VoxelGrid grid_;
  float ox_{0}, oy_{0}, oz_{0}, inv_h_{0};
  int blocks_[3]{0, 0, 0};
  std::vector<std::uint32_t> block_index_;
  std::vector<float> values_;  ///< 729 a block
  double error_bound_{0.0};
  double band_{0.0};
};

}  // namespace abstand
