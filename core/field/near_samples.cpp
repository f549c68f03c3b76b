// Samples at the vertices of blocks: each vertex is measured by one block and copied by the others.
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
// Blocks that one thread measures after each other.
constexpr int kTogether = 64;

// Which blocks are kept, as seen from one of them: at (1, 0, 0) the next along x, and so on.
struct Neighbours {
  std::uint32_t block[2][2][2];  ///< [z][y][x]

  // The block that computes a vertex: the farthest along the axes that holds it. kNoBlock for deep ones, too.
  std::uint32_t owner(int i, int j, int k) const {
    return block[k == kCells ? 1 : 0][j == kCells ? 1 : 0][i == kCells ? 1 : 0];
  }
};

// Where the vertices of a block are: the first one, their spacing, and by how much (m) rounding moves them.
struct BlockFrame {
  Vector3d origin;
  double h, rounding;
};

// Values at those of a block's 9^3 vertices that it owns itself, or that no kept block owns. Back and forth,
// so that each vertex is near the one before it: its nearest triangle is a good hint. When the two distances
// together exceed the way between the vertices by more than their `rounding`, no surface lies between and the
// sign stays; but across the holes of an open mesh the sign changes anywhere. `nearest_at(p, i, j, k, hint)`:
// the nearest point of the surface to vertex (i, j, k), which lies at p.
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

// Blocks side by side, and the features of a mesh that may be nearest to a vertex of theirs.
struct Region {
  Vector3i first, size;
  NearDistances::List list;

  NearDistances::Block vertices() const { return {kCells * first, kCells * size + Vector3i::Ones()}; }
  // The two halves along the longest axis.
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

// Calls fn(block) for the kept blocks of a region, each as a region of its own, and parts it until `most`
// blocks are left.
template <class Kept, class Fn>
void forRegions(const NearDistances& distances, const Region& region, int most, Kept&& kept,
                std::uint32_t& hint, Fn&& fn) {
  bool any = false;
  for (int k = 0; k < region.size.z() && !any; ++k) {
    for (int j = 0; j < region.size.y() && !any; ++j) {
      for (int i = 0; i < region.size.x() && !any; ++i) any = kept(region.first + Vector3i(i, j, k));
    }
  }
  if (!any) return;
  if (region.size.prod() <= most) {
    fn(region);
    return;
  }
  for (Region& half : region.halves()) {
    distances.near(half.vertices(), region.list, hint, half.list);
    forRegions(distances, half, most, kept, hint, fn);
  }
}

// The distances of a block's vertices, as far as it has to know them: those on its far sides only where a
// neighbour that owns them is not kept.
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

// The vertices that fillBlock left to their owners.
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

Neighbours neighboursOf(const KeptBlocks& kept, std::size_t b) {
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

BlockFrame frameOf(const KeptBlocks& kept, std::size_t b, double rounding) {
  return {kept.grid.corner(kept.grid.placeOf(b)), kept.grid.voxel, rounding};
}

// Of shapes, whose nearest points have closed forms. `store(n, fill)`: fill(to) writes what the kept block n
// measures itself.
template <class Store>
void measureShape(const geometry::Surface& surface, const KeptBlocks& kept, double rounding, int threads,
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

// Of meshes: features that may be nearest are shared by the blocks of a region.
template <class Store>
void measureMesh(const geometry::MeshSurface& mesh, const KeptBlocks& kept, double rounding, int threads,
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

// `store` keeps what blocks measure themselves in `values`.
template <class Value, class Store>
void sampleInto(std::vector<Value>& values, const geometry::Surface& surface, const KeptBlocks& kept,
                double rounding, int threads, Store&& store) {
  values.resize(kept.blocks.size() * kBlockValues);
  if (const auto* mesh = dynamic_cast<const geometry::MeshSurface*>(&surface))
    measureMesh(*mesh, kept, rounding, threads, store);
  else
    measureShape(surface, kept, rounding, threads, store);
  // Owners are filled; what is read here was computed above and is written by none.
  parallelFor(threads, kept.blocks.size(), [&](std::size_t n) {
    copyFromOwners(neighboursOf(kept, kept.blocks[n]), values.data(), &values[n * kBlockValues]);
  });
}

}  // namespace

std::vector<float> sampleBlocks(const geometry::Surface& surface, const KeptBlocks& kept, double rounding,
                                int threads) {
  std::vector<float> values;
  sampleInto(values, surface, kept, rounding, threads,
             [&](std::size_t n, auto&& fill) { fill(&values[n * kBlockValues]); });
  return values;
}

std::vector<std::int16_t> sampleQuanta(const geometry::Surface& surface, const KeptBlocks& kept,
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
