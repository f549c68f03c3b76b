// Signed distance field near the surface.
#pragma once

#include <cstdint>
#include <vector>

#include "core/field/grid.hpp"
#include "core/field/near_blocks.hpp"
#include "core/geometry/surface.hpp"

namespace abstand::field {

/// Signed distances (positive outside) at the corners of a grid's voxels, in blocks of 8 x 8 x 8 voxels (9^3
/// vertices, so that a sample needs one block). Dense: all blocks of the grid are stored. Sparse: only blocks
/// within the band of the surface, and the blocks inside the body if all stored blocks are small enough
/// (kWholeInsideBytes). In larger fields blocks deeper than kInnerBand voxels store no samples, so that
/// memory is proportional to the surface; there distances are interpolated between the corners of the blocks
/// (deep blocks). Values are 16-bit multiples of a quantum that fits the largest of them, interpolated
/// trilinearly. Constant after construction; samples may be taken on any number of threads.
class NearField {
 public:
  static constexpr int kCells = BlockGrid::kCells;
  static constexpr int kVertices = kCells + 1;
  static constexpr int kBlockValues = kVertices * kVertices * kVertices;
  static constexpr std::uint32_t kNoBlock = 0xffffffffu;
  static constexpr std::uint32_t kDeepBlock = 0xfffffffeu;
  static constexpr std::size_t kWholeInsideBytes = 24'000'000;
  static constexpr double kInnerBand = 2.0;  ///< voxels

  /// Data for queries, of one point or many at a time.
  struct View {
    float origin[3];
    float inv_h;
    float cells[3];     ///< of all blocks together
    int blocks[2];      ///< along x and y
    float quantum;      ///< m for each step of a value
    float error_bound;  ///< m
    float h2;           ///< squared voxel size, rounded up
    float slope;        ///< upper bound of the length of sample()'s gradient
    float band;         ///< m
    const std::uint32_t* block_index;
    const std::int16_t* values;
    // Of deep blocks.
    int deep_vertices[2];      ///< along x and y
    float deep_quantum;        ///< m
    float deep_error;          ///< m; error_bound if there are no deep blocks
    const std::int16_t* deep;  ///< distances at the corners of all blocks, 0 if no deep block has the corner;
                               ///< or null
  };

  NearField() = default;
  /// `band` (m): outside of the body, blocks farther than this from the surface are left out; infinity:
  /// dense. `whole_inside` (bytes): size of the field up to which all blocks inside store samples. Throws
  /// UsageError if the blocks would take more than 2 GB.
  NearField(const geometry::Surface& surface, const VoxelGrid& grid, double band, int threads = 0,
            std::size_t whole_inside = kWholeInsideBytes);

  /// Trilinear signed distance (m) and its gradient (dimensionless, not normalised). False if p lies in no
  /// stored and no deep block, and for NaN and infinity; then nothing is written.
  bool sample(float px, float py, float pz, float& distance) const;
  bool sampleGradient(float px, float py, float pz, float& distance, float gradient[3]) const;

  /// Certified for every p with sample() true: |sample - true signed distance| <= errorBound(). It is
  /// sqrt(3)/2 voxels plus half a quantum and float rounding: for a 1-Lipschitz function the error is at most
  /// sum_i w_i |p - v_i|, which is at most the square root of sum_i w_i |p - v_i|^2 = sum_axes h^2 t (1 - t)
  /// <= 3 h^2 / 4 (Jensen). If a mesh is not watertight the signed distance jumps across its holes; then only
  /// sample <= unsigned distance + bound is certain. In deep blocks the bound is deepErrorBound(), in the
  /// same way for their size.
  double errorBound() const { return error_bound_; }
  double deepErrorBound() const { return deep_error_; }
  /// True if p lies in a deep block, which is deeper than kInnerBand voxels. A dense field has none.
  bool deep(float px, float py, float pz) const;
  /// m; a sample at a vertex errs by at most half of it.
  double quantum() const { return quantum_; }
  View view() const;
  /// If sample() is false, the surface is farther than this (m).
  double band() const { return band_; }
  std::size_t memoryBytes() const;
  template <class Archive>
  void archive(Archive& ar) {
    ar(grid_, ox_, oy_, oz_, inv_h_, cells_, blocks_, block_index_, values_, quantum_, slope_, error_bound_,
       band_, deep_, deep_quantum_, deep_error_);
  }
  std::size_t blocks() const { return values_.size() / kBlockValues; }
  const VoxelGrid& grid() const { return grid_; }

 private:
  /// Values at a cell's first corner, and the position of p in the cell (0 to 1). Null outside.
  const std::int16_t* cellOf(float px, float py, float pz, float& x, float& y, float& z) const {
    const float gx = (px - ox_) * inv_h_, gy = (py - oy_) * inv_h_, gz = (pz - oz_) * inv_h_;
    // The negated form also rejects NaN.
    if (!(gx >= 0.0f && gy >= 0.0f && gz >= 0.0f && gx < cells_[0] && gy < cells_[1] && gz < cells_[2])) {
      return nullptr;
    }
    const unsigned i = static_cast<int>(gx), j = static_cast<int>(gy), k = static_cast<int>(gz);
    const std::uint32_t block =
        block_index_[(std::size_t(k / kCells) * blocks_[1] + j / kCells) * blocks_[0] + i / kCells];
    if (block >= kDeepBlock) return nullptr;
    x = gx - static_cast<float>(static_cast<int>(i));
    y = gy - static_cast<float>(static_cast<int>(j));
    z = gz - static_cast<float>(static_cast<int>(k));
    return &values_[std::size_t(block) * kBlockValues + ((k % kCells) * kVertices + j % kCells) * kVertices +
                    i % kCells];
  }

  /// The eight values around a point: pointer to the first, strides along y and z, and the position between
  /// them (0 to 1).
  struct Cell {
    const std::int16_t* values{nullptr};  ///< null: no block
    int row{kVertices}, slice{kVertices * kVertices};
    float x, y, z;
    float quantum;  ///< m
    float inv_h;    ///< 1 / m
  };
  /// Null values if p is in no stored and no deep block.
  Cell anyCellOf(float px, float py, float pz) const;
  Cell deepCellOf(float px, float py, float pz) const;
  /// Band and rounding for which samples must be accurate.
  struct Precision {
    double band, rounding;  ///< m
  };
  BlockGrid setUpGrid();
  void measure(const geometry::Surface& surface, const SelectedBlocks& kept, const Precision& precision,
               int threads);
  float steepest(int threads) const;
  void measureDeep(const geometry::Surface& surface, const BlockGrid& grid, double rounding, int threads);

  VoxelGrid grid_;
  float ox_{0}, oy_{0}, oz_{0}, inv_h_{0};
  float cells_[3]{0, 0, 0};  ///< of all blocks together
  int blocks_[3]{0, 0, 0};
  std::vector<std::uint32_t> block_index_;
  std::vector<std::int16_t> values_;  ///< 729 for each block, in quanta
  float quantum_{0.0f};
  float slope_{0.0f};
  double error_bound_{0.0};
  double band_{0.0};
  std::vector<std::int16_t> deep_;  ///< distances at the corners of blocks, in quanta of their own
  float deep_quantum_{0.0f};
  double deep_error_{0.0};
};

inline NearField::Cell NearField::anyCellOf(float px, float py, float pz) const {
  Cell cell;
  cell.values = cellOf(px, py, pz, cell.x, cell.y, cell.z);
  cell.quantum = quantum_;
  cell.inv_h = inv_h_;
  return cell.values != nullptr || deep_.empty() ? cell : deepCellOf(px, py, pz);
}

inline bool NearField::sample(float px, float py, float pz, float& distance) const {
  const Cell cell = anyCellOf(px, py, pz);
  if (cell.values == nullptr) return false;
  const auto along = [&cell](const std::int16_t* p) {
    const float first = p[0], second = p[1];
    return first + cell.x * (second - first);
  };
  const std::int16_t* v = cell.values;
  const float a = along(v), b = along(v + cell.row), c = along(v + cell.slice),
              d = along(v + cell.slice + cell.row);
  const float near = a + cell.y * (b - a), far = c + cell.y * (d - c);
  distance = (near + cell.z * (far - near)) * cell.quantum;
  return true;
}

}  // namespace abstand::field
