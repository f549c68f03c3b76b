// Selects the blocks of a near field that store samples.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/geometry/surface.hpp"

namespace abstand::field {

/// Adjacent cubes of kCells voxels, starting at `origin` (body frame, m).
struct BlockGrid {
  static constexpr int kCells = 8;
  Vector3d origin;
  double voxel;   ///< m
  Vector3i size;  ///< blocks along each axis

  std::size_t blocks() const { return std::size_t(size.x()) * size.y() * size.z(); }
  Vector3i placeOf(std::size_t b) const {
    const auto nx = static_cast<std::size_t>(size.x()), ny = static_cast<std::size_t>(size.y());
    return {static_cast<int>(b % nx), static_cast<int>(b / nx % ny), static_cast<int>(b / (nx * ny))};
  }
  std::size_t indexOf(const Vector3i& place) const {
    return (std::size_t(place.z()) * size.y() + place.y()) * size.x() + place.x();
  }
  Vector3d corner(const Vector3i& place) const { return origin + kCells * voxel * place.cast<double>(); }
  /// The far corner of the last block.
  Vector3d end() const { return corner(placeOf(blocks() - 1)).array() + kCells * voxel; }
};

enum class BlockKind : std::uint8_t {
  kOutside,  ///< farther outside than the outer band
  kNear,     ///< partly within one of the bands
  kDeep      ///< inside, entirely deeper than the inner band
};

/// Kind of every block. `outer`, `inner` (m): widths of the bands outside and inside of the surface. For a
/// watertight body, cubes of many blocks are classified at once if the surface is farther away than their
/// size, so the time is proportional to the surface; otherwise block by block. The result does not depend on
/// the number of threads.
std::vector<BlockKind> classifyBlocks(const geometry::Surface& surface, const BlockGrid& grid, double outer,
                                      double inner, int threads);

/// Blocks that store samples.
struct SelectedBlocks {
  BlockGrid grid;
  /// for each block of the grid: its index in `blocks`, or NearField::kNoBlock or kDeepBlock
  std::vector<std::uint32_t> index;
  std::vector<std::uint32_t> blocks;  ///< block numbers in the grid, ascending
  bool all_inside{false};             ///< deep blocks inside are stored too
  bool any_deep{false};               ///< some blocks are deep inside and not stored
};

/// See the parameters of NearField's constructor.
struct BlockLimits {
  double band;               ///< m
  std::size_t whole_inside;  ///< bytes
};

/// Throws UsageError if the stored blocks would take more than 2 GB.
SelectedBlocks selectBlocks(const geometry::Surface& surface, const BlockGrid& grid,
                            const BlockLimits& limits, int threads);

}  // namespace abstand::field
