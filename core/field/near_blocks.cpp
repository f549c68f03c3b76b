// Selects the blocks of a near field that store samples.
#include "core/field/near_blocks.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "core/base/parallel.hpp"
#include "core/field/grid.hpp"
#include "core/field/near_field.hpp"

namespace abstand::field {
namespace {

// Blocks along an edge of a cube; a cube is one unit of work for a thread.
constexpr int kCubeBlocks = 8;
constexpr double kMaxBytes = 2e9;

double distanceToBox(const geometry::Bounds& box, const Vector3d& p) {
  return (box.lower - p).cwiseMax(p - box.upper).cwiseMax(0.0).norm();
}

class Classifier {
 public:
  Classifier(const geometry::Surface& surface, const BlockGrid& grid, double outer, double inner,
             std::vector<BlockKind>& kinds)
      : surface_(surface),
        grid_(grid),
        body_(surface.bounds()),
        outer_(outer),
        inner_(inner),
        kinds_(kinds) {}

  /// Classifies the blocks of a cube of `count` blocks along each edge, as far as they are in the grid.
  void cube(const Vector3i& first, int count, bool halve, std::uint32_t& hint) {
    if ((first.array() >= grid_.size.array()).any()) return;
    const double edge = count * BlockGrid::kCells * grid_.voxel;
    const Vector3d centre = grid_.corner(first).array() + 0.5 * edge;
    if (count == 1) {
      kinds_[grid_.indexOf(first)] = kindOf(centre, BlockGrid::kCells, hint);
      return;
    }
    if (halve) {
      const double half = 0.5 * edge;
      BlockKind kind = BlockKind::kNear;
      if (distanceToBox(body_, centre) > outer_ + kCubeDiagonal * half) {
        kind = BlockKind::kOutside;
      } else {
        const geometry::SurfacePoint nearest = surface_.closest(centre, hint);
        hint = nearest.hint;
        // The cube contains no surface, so its side is that of its centre.
        if (nearest.distance > std::max(outer_, inner_) + kCubeDiagonal * half)
          kind = surface_.inside(centre, nearest) ? BlockKind::kDeep : BlockKind::kOutside;
      }
      if (kind != BlockKind::kNear) {
        each(first, count, 1, [&](const Vector3i& at) { kinds_[grid_.indexOf(at)] = kind; });
        return;
      }
    }
    const int step = halve ? count / 2 : 1;
    each(first, count, step, [&](const Vector3i& at) { cube(at, step, halve, hint); });
  }

 private:
  template <class Fn>
  void each(const Vector3i& first, int count, int step, Fn&& fn) const {
    const Vector3i end = (first.array() + count).min(grid_.size.array());
    for (int k = first.z(); k < end.z(); k += step) {
      for (int j = first.y(); j < end.y(); j += step) {
        for (int i = first.x(); i < end.x(); i += step) fn(Vector3i(i, j, k));
      }
    }
  }

  /// Kind of a cube about c with `voxels` voxels along an edge. The distance is 1-Lipschitz, so one query
  /// decides for all cubes except those at the edge of a band, which are divided once.
  BlockKind kindOf(const Vector3d& c, int voxels, std::uint32_t& hint) const {
    const double half = 0.5 * voxels * grid_.voxel;
    if (distanceToBox(body_, c) > outer_ + kCubeDiagonal * half) return BlockKind::kOutside;
    const geometry::SurfacePoint nearest = surface_.closest(c, hint);
    hint = nearest.hint;
    const bool inside = surface_.inside(c, nearest);
    const double band = inside ? inner_ : outer_;
    const BlockKind rest = inside ? BlockKind::kDeep : BlockKind::kOutside;
    if (nearest.distance <= band + half) return BlockKind::kNear;
    if (nearest.distance > band + kCubeDiagonal * half) return rest;
    if (voxels < BlockGrid::kCells) return BlockKind::kNear;
    for (int i = 0; i < 8; ++i) {
      const Vector3d offset = 0.5 * half * Vector3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
      if (kindOf(c + offset, voxels / 2, hint) != rest) return BlockKind::kNear;
    }
    return rest;
  }

  const geometry::Surface& surface_;
  const BlockGrid& grid_;
  const geometry::Bounds body_;
  const double outer_, inner_;
  std::vector<BlockKind>& kinds_;
};

}  // namespace

std::vector<BlockKind> classifyBlocks(const geometry::Surface& surface, const BlockGrid& grid, double outer,
                                      double inner, int threads) {
  std::vector<BlockKind> kinds(grid.blocks(), BlockKind::kOutside);
  const Vector3i cubes = (grid.size.array() + kCubeBlocks - 1) / kCubeBlocks;
  const bool halve = surface.watertight();
  parallelFor(threads, std::size_t(cubes.x()) * cubes.y() * cubes.z(), [&](std::size_t n) {
    const auto nx = static_cast<std::size_t>(cubes.x()), ny = static_cast<std::size_t>(cubes.y());
    const Vector3i place(static_cast<int>(n % nx), static_cast<int>(n / nx % ny),
                         static_cast<int>(n / (nx * ny)));
    std::uint32_t hint = geometry::kNoHint;
    Classifier(surface, grid, outer, inner, kinds).cube(kCubeBlocks * place, kCubeBlocks, halve, hint);
  });
  return kinds;
}

SelectedBlocks selectBlocks(const geometry::Surface& surface, const BlockGrid& grid,
                            const BlockLimits& limits, int threads) {
  const std::size_t all = grid.blocks();
  std::vector<BlockKind> kinds(all, BlockKind::kNear);
  if (std::isfinite(limits.band))
    kinds = classifyBlocks(surface, grid, limits.band, NearField::kInnerBand * grid.voxel, threads);
  const auto inside = static_cast<double>(std::count(kinds.begin(), kinds.end(), BlockKind::kDeep));
  const auto near = static_cast<double>(std::count(kinds.begin(), kinds.end(), BlockKind::kNear));
  constexpr double kBlockBytes = NearField::kBlockValues * sizeof(std::int16_t);
  const bool keeps_inside = (near + inside) * kBlockBytes <= static_cast<double>(limits.whole_inside);
  if ((keeps_inside ? near + inside : near) * kBlockBytes > kMaxBytes) {
    throw UsageError(
        "the distance field would take more than 2 GB; choose a larger voxel size or the mixed field");
  }
  SelectedBlocks kept{grid,
                      std::vector<std::uint32_t>(all, NearField::kNoBlock),
                      {},
                      keeps_inside,
                      !keeps_inside && inside > 0.0};
  for (std::size_t b = 0; b < all; ++b) {
    if (kinds[b] == BlockKind::kOutside) continue;
    if (kinds[b] == BlockKind::kDeep && !keeps_inside) {
      kept.index[b] = NearField::kDeepBlock;
      continue;
    }
    kept.index[b] = static_cast<std::uint32_t>(kept.blocks.size());
    kept.blocks.push_back(static_cast<std::uint32_t>(b));
  }
  return kept;
}

}  // namespace abstand::field
