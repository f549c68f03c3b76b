// Samples at the vertices of blocks: each vertex is computed by one block and copied by the others.
#include "core/field/near_samples.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "core/base/parallel.hpp"
#include "core/field/field_quanta.hpp"
#include "core/field/near_distances.hpp"
#include "core/field/near_field.hpp"

namespace abstand::field {
namespace {

constexpr int kCells = NearField::kCells;
constexpr int kVertices = NearField::kVertices;
constexpr int kBlockValues = NearField::kBlockValues;
// Consecutive blocks in one unit of work.
constexpr int kTogether = 64;

// Which neighbours of a block are stored: (1, 0, 0) is the next along x, and so on.
struct Neighbours {
  std::uint32_t block[2][2][2];  ///< [z][y][x]

  // The block that computes a vertex: the last one along each axis that contains it. kNoBlock also for deep
  // blocks.
  std::uint32_t owner(int i, int j, int k) const {
    return block[k == kCells ? 1 : 0][j == kCells ? 1 : 0][i == kCells ? 1 : 0];
  }
};

// Vertices of a block: the first one, their spacing, and their rounding error (m).
struct BlockFrame {
  Vector3d origin;
  double h, rounding;
};

// Fills those of a block's 9^3 vertices that it owns, or that no stored block owns. Serpentine order, so that
// the nearest triangle of the previous vertex is a good hint. If the sum of two neighbouring distances
// exceeds the vertex spacing by more than `rounding`, no surface lies between them and the sign is the same;
// except for open meshes, where the sign may change across holes. `nearest_at(p, i, j, k, hint)`: nearest
// surface point to vertex (i, j, k), which is at p.
template <class NearestAt>
void fillBlock(const geometry::Surface& surface, const Neighbours& neighbours, const BlockFrame& frame,
               NearestAt&& nearest_at, float* values) {
  const auto& [origin, h, rounding] = frame;
  const bool closed = surface.watertight();
  const std::uint32_t self = neighbours.block[0][0][0];
  geometry::SurfacePoint nearest{origin, -1.0, geometry::kNoHint};
  Vector3d before = origin;
  bool inside = false;
  int i = 0, j = 0, di = 1, dj = 1;
  for (int k = 0; k < kVertices; ++k) {
    for (int row = 0; row < kVertices; ++row) {
      for (int column = 0; column < kVertices; ++column) {
        const std::uint32_t owner = neighbours.owner(i, j, k);
        if (owner == self || owner == NearField::kNoBlock) {
          const Vector3d p = origin + h * Vector3d(i, j, k);
          const double distance_before = nearest.distance;
          nearest = nearest_at(p, i, j, k, nearest.hint);
          const bool same_side =
              closed && nearest.distance + distance_before > (p - before).norm() + rounding;
          if (!same_side || distance_before < 0.0) inside = surface.inside(p, nearest);
          before = p;
          values[(k * kVertices + j) * kVertices + i] =
              static_cast<float>(inside ? -nearest.distance : nearest.distance);
        }
        if (column + 1 < kVertices) i += di;
      }
      di = -di;
      if (row + 1 < kVertices) j += dj;
    }
    dj = -dj;
  }
}

// A box of blocks, and the features of a mesh that may be nearest to one of their vertices.
struct Region {
  Vector3i first, size;
  NearDistances::List list;

  NearDistances::Block vertices() const { return {kCells * first, kCells * size + Vector3i::Ones()}; }
  // Halves along the longest axis.
  std::array<Region, 2> halves() const {
    int axis = 0;
    size.maxCoeff(&axis);
    std::array<Region, 2> out{Region{first, size, {}}, Region{first, size, {}}};
    out[0].size[axis] = size[axis] / 2;
    out[1].first[axis] += out[0].size[axis];
    out[1].size[axis] -= out[0].size[axis];
    return out;
  }
};

// Calls fn(block) for each stored block of a region, with a region of its own; bisects the region down to
// `max_blocks` blocks.
template <class Kept, class Fn>
void forRegions(const NearDistances& distances, const Region& region, int max_blocks, Kept&& kept,
                std::uint32_t& hint, Fn&& fn) {
  bool any = false;
  for (int k = 0; k < region.size.z() && !any; ++k) {
    for (int j = 0; j < region.size.y() && !any; ++j) {
      for (int i = 0; i < region.size.x() && !any; ++i) any = kept(region.first + Vector3i(i, j, k));
    }
  }
  if (!any) return;
  if (region.size.prod() <= max_blocks) {
    fn(region);
    return;
  }
  for (Region& half : region.halves()) {
    distances.near(half.vertices(), region.list, hint, half.list);
    forRegions(distances, half, max_blocks, kept, hint, fn);
  }
}

// Distances of the vertices that a block computes: those on its far sides only if the neighbour that owns
// them is not stored.
void measureBlock(const NearDistances& distances, const Region& block, const Neighbours& neighbours,
                  std::uint32_t& hint, geometry::SurfacePoint (*nearest)[kVertices][kVertices]) {
  constexpr int kPart = kCells / 2;
  static_assert(kPart + 1 <= NearDistances::kMaxSize);
  Vector3i rim = Vector3i::Zero();
  for (int c = 1; c < 8; ++c) {
    if (neighbours.block[c >> 2][c >> 1 & 1][c & 1] != NearField::kNoBlock) continue;
    rim = rim.cwiseMax(Vector3i(c & 1, c >> 1 & 1, c >> 2));
  }
  NearDistances::Nearest part;
  NearDistances::List list;
  for (int c = 0; c < 8; ++c) {
    const Vector3i far(c & 1, c >> 1 & 1, c >> 2), first = kPart * far;
    const NearDistances::Block vertices{kCells * block.first + first,
                                        Vector3i::Constant(kPart) + far.cwiseProduct(rim)};
    distances.near(vertices, block.list, hint, list);
    distances.distances(vertices, list, part);
    for (int k = 0; k < vertices.size.z(); ++k) {
      for (int j = 0; j < vertices.size.y(); ++j) {
        for (int i = 0; i < vertices.size.x(); ++i) {
          nearest[first.z() + k][first.y() + j][first.x() + i] = {
              Vector3d::Zero(), double(part.distance[k][j][i]), part.slot[k][j][i]};
        }
      }
    }
  }
}

// Copies the vertices that fillBlock() left to their owners.
template <class Value>
void copyFromOwners(const Neighbours& neighbours, const Value* all_values, Value* values) {
  for (int k = 0; k < kVertices; ++k) {
    for (int j = 0; j < kVertices; ++j) {
      for (int i = k == kCells || j == kCells ? 0 : kCells; i < kVertices; ++i) {
        const std::uint32_t owner = neighbours.owner(i, j, k);
        if (owner == neighbours.block[0][0][0] || owner == NearField::kNoBlock) continue;
        const int at = ((k % kCells) * kVertices + j % kCells) * kVertices + i % kCells;
        values[(k * kVertices + j) * kVertices + i] =
            all_values[std::size_t(owner) * NearField::kBlockValues + at];
      }
    }
  }
}

Neighbours neighboursOf(const SelectedBlocks& kept, std::size_t b) {
  const Vector3i place = kept.grid.placeOf(b);
  Neighbours neighbours;
  for (int c = 0; c < 8; ++c) {
    const Vector3i at = place + Vector3i(c & 1, c >> 1 & 1, c >> 2);
    const std::uint32_t block =
        (at.array() < kept.grid.size.array()).all() ? kept.index[kept.grid.indexOf(at)] : NearField::kNoBlock;
    neighbours.block[c >> 2][c >> 1 & 1][c & 1] =
        block == NearField::kDeepBlock ? NearField::kNoBlock : block;
  }
  return neighbours;
}

BlockFrame frameOf(const SelectedBlocks& kept, std::size_t b, double rounding) {
  return {kept.grid.corner(kept.grid.placeOf(b)), kept.grid.voxel, rounding};
}

// For shapes, whose nearest points have closed forms. `store(n, fill)`: fill(to) writes the values that
// stored block n computes itself.
template <class Store>
void measureShape(const geometry::Surface& surface, const SelectedBlocks& kept, double rounding, int threads,
                  Store&& store) {
  parallelFor(threads, kept.blocks.size(), [&](std::size_t n) {
    const std::size_t b = kept.blocks[n];
    store(n, [&](float* to) {
      fillBlock(
          surface, neighboursOf(kept, b), frameOf(kept, b, rounding),
          [&](const Vector3d& p, int, int, int, std::uint32_t hint) { return surface.closest(p, hint); }, to);
    });
  });
}

// For meshes: candidate features are shared by the blocks of a region.
template <class Store>
void measureMesh(const geometry::MeshSurface& mesh, const SelectedBlocks& kept, double rounding, int threads,
                 Store&& store) {
  const NearDistances distances(mesh, kept.grid.origin, kept.grid.voxel);
  const auto isKept = [&](const Vector3i& block) {
    return kept.index[kept.grid.indexOf(block)] < NearField::kDeepBlock;
  };
  std::vector<Region> regions;
  std::uint32_t first_hint = geometry::kNoHint;
  const Region whole{Vector3i::Zero(), kept.grid.size, distances.all()};
  forRegions(distances, whole, kTogether, isKept, first_hint, [&](const Region& r) { regions.push_back(r); });
  parallelFor(threads, regions.size(), [&](std::size_t r) {
    std::uint32_t hint = geometry::kNoHint;
    const auto nearest = std::make_unique<geometry::SurfacePoint[][kVertices][kVertices]>(kVertices);
    forRegions(distances, regions[r], 1, isKept, hint, [&](const Region& block) {
      const std::size_t b = kept.grid.indexOf(block.first);
      const Neighbours neighbours = neighboursOf(kept, b);
      measureBlock(distances, block, neighbours, hint, nearest.get());
      store(kept.index[b], [&](float* to) {
        fillBlock(
            mesh, neighbours, frameOf(kept, b, rounding),
            [&](const Vector3d&, int i, int j, int k, std::uint32_t) { return nearest[k][j][i]; }, to);
      });
    });
    regions[r].list = {};
  });
}

// `store` writes the values that blocks compute themselves to `values`.
template <class Value, class Store>
void sampleInto(std::vector<Value>& values, const geometry::Surface& surface, const SelectedBlocks& kept,
                double rounding, int threads, Store&& store) {
  values.resize(kept.blocks.size() * kBlockValues);
  if (const auto* mesh = dynamic_cast<const geometry::MeshSurface*>(&surface))
    measureMesh(*mesh, kept, rounding, threads, store);
  else
    measureShape(surface, kept, rounding, threads, store);
  // Owners are filled; values read here were computed above and are not written.
  parallelFor(threads, kept.blocks.size(), [&](std::size_t n) {
    copyFromOwners(neighboursOf(kept, kept.blocks[n]), values.data(), &values[n * kBlockValues]);
  });
}

}  // namespace

std::vector<float> sampleBlocks(const geometry::Surface& surface, const SelectedBlocks& kept, double rounding,
                                int threads) {
  std::vector<float> values;
  sampleInto(values, surface, kept, rounding, threads,
             [&](std::size_t n, auto&& fill) { fill(&values[n * kBlockValues]); });
  return values;
}

std::vector<std::int16_t> sampleQuanta(const geometry::Surface& surface, const SelectedBlocks& kept,
                                       double rounding, float quantum, int threads) {
  std::vector<std::int16_t> values;
  sampleInto(values, surface, kept, rounding, threads, [&](std::size_t n, auto&& fill) {
    std::array<float, kBlockValues> block{};
    fill(block.data());
    std::transform(block.begin(), block.end(), &values[n * kBlockValues],
                   [quantum](float value) { return toQuanta(value, quantum); });
  });
  return values;
}

}  // namespace abstand::field
