// Which blocks of a near field carry samples.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/geometry/surface.hpp"

namespace abstand::field {

/// Cubes of kCells voxels, side by side from `origin` on (body frame, m).
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
  kOutside,  ///< farther from the surface than the outer band
  kNear,     ///< comes within one of the bands
  kDeep      ///< inside, and all of it deeper than the inner band
};

/// The kind of every block. `outer` and `inner` (m): how far outside and inside of the body blocks are near.
/// Of a watertight body, cubes of many blocks are decided at once where the surface is farther than they are
/// wide, so the time goes with the surface; others are asked block by block. Any number of threads gives the
/// same.
std::vector<BlockKind> classifyBlocks(const geometry::Surface& surface, const BlockGrid& grid, double outer,
                                      double inner, int threads);

/// The blocks that carry samples.
struct KeptBlocks {
  BlockGrid grid;
  /// Of each block of the grid: its number among `blocks`, or NearField::kNoBlock or kDeepBlock.
  std::vector<std::uint32_t> index;
  std::vector<std::uint32_t> blocks;  ///< of the grid, in its order
  bool all_inside{false};             ///< those deep inside, too
  bool any_deep{false};               ///< some are deep inside and not kept
};

/// As the parameters of NearField's constructor.
struct KeepLimits {
  double band;               ///< m
  std::size_t whole_inside;  ///< bytes
};

/// Throws UsageError when the kept blocks would take more than 2 GB.
KeptBlocks keepBlocks(const geometry::Surface& surface, const BlockGrid& grid, const KeepLimits& limits,
                      int threads);

}  // namespace abstand::field
