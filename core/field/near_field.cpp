// Signed float distances about the surface.
#include "core/field/near_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <utility>

#include "core/base/error.hpp"
#include "core/base/parallel.hpp"
#include "core/field/field_quanta.hpp"
#include "core/field/near_distances.hpp"

namespace abstand::field {
namespace {

constexpr int kCells = NearField::kCells;
constexpr int kVertices = NearField::kVertices;
constexpr double kFloatEpsilon = 0x1p-23;
constexpr double kMaxBytes = 2e9;
constexpr float kSlopeRounding = 1.0f + 1e-5f;
// Blocks that one thread measures after each other.
constexpr int kTogether = 64;

// A row of a block's values and how far two such are apart, side by side.
using EightNumbers [[gnu::vector_size(16)]] = std::int16_t;
using EightSlopes [[gnu::vector_size(16)]] = std::uint16_t;
struct EightValues {
  explicit EightValues(const std::int16_t* p) { std::memcpy(&v, p, sizeof v); }
  EightNumbers v;
};
static_assert(sizeof(EightNumbers) == kCells * sizeof(std::int16_t));
EightSlopes apart(const EightValues& a, const EightValues& b) {
  const auto p = reinterpret_cast<EightSlopes>(a.v), q = reinterpret_cast<EightSlopes>(b.v);
  return a.v > b.v ? p - q : q - p;
}
EightSlopes larger(EightSlopes a, EightSlopes b) { return a > b ? a : b; }

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

}  // namespace

NearField::NearField(const geometry::Surface& surface, const VoxelGrid& grid, double band, int threads,
                     std::size_t whole_inside)
    : grid_(grid) {
  const double h = grid.voxel_size;
  const Vector3d corner = grid.first_centre.array() - 0.5 * h;
  ox_ = static_cast<float>(corner.x());
  oy_ = static_cast<float>(corner.y());
  oz_ = static_cast<float>(corner.z());
  inv_h_ = static_cast<float>(1.0 / h);
  // The vertices lie where sample() takes them to be.
  const Vector3d origin(ox_, oy_, oz_);
  const double step = 1.0 / double(inv_h_);
  for (int k = 0; k < 3; ++k) {
    blocks_[k] = (grid.size[k] + kCells - 1) / kCells;
    cells_[k] = static_cast<float>(blocks_[k] * kCells);
  }
  const BlockGrid cubes{origin, step, Vector3i(blocks_[0], blocks_[1], blocks_[2])};
  const std::size_t all = cubes.blocks();
  const auto blockOrigin = [&](std::size_t b) -> Vector3d { return cubes.corner(cubes.placeOf(b)); };

  // Rounding moves a point by a few units in the last place of the coordinates, and the values likewise;
  // those of a mesh were measured in float about its middle.
  const Vector3d end = blockOrigin(all - 1).array() + kCells * step;
  const double rounding =
      8.0 * kFloatEpsilon *
      (origin.cwiseAbs().cwiseMax(end.cwiseAbs()).maxCoeff() + 2.0 * (end - origin).norm());
  const geometry::Bounds body = surface.bounds();
  std::vector<BlockKind> kinds(all, BlockKind::kNear);
  if (std::isfinite(band)) kinds = classifyBlocks(surface, cubes, band, kInnerBand * step, threads);
  const auto inside = static_cast<double>(std::count(kinds.begin(), kinds.end(), BlockKind::kDeep));
  const auto near = static_cast<double>(std::count(kinds.begin(), kinds.end(), BlockKind::kNear));
  constexpr double kBlockBytes = kBlockValues * sizeof(std::int16_t);
  const bool keeps_inside = (near + inside) * kBlockBytes <= static_cast<double>(whole_inside);
  if ((keeps_inside ? near + inside : near) * kBlockBytes > kMaxBytes) {
    throw UsageError(
        "the distance field would take more than 2 GB; choose a larger voxel size or the mixed field");
  }
  block_index_.assign(all, kNoBlock);
  std::vector<std::uint32_t> kept;
  for (std::size_t b = 0; b < all; ++b) {
    if (kinds[b] == BlockKind::kDeep && !keeps_inside) block_index_[b] = kDeepBlock;
    if (kinds[b] == BlockKind::kOutside || block_index_[b] == kDeepBlock) continue;
    block_index_[b] = static_cast<std::uint32_t>(kept.size());
    kept.push_back(static_cast<std::uint32_t>(b));
  }
  // A sparse field's distances are known to be below this, so each block is rounded to quanta as soon as it
  // is measured and the floats of all need not be kept: a block near the surface has a cube of half its width
  // whose centre is no farther than the band and that cube's half diagonal. Else the largest decides.
  const double most =
      std::max(band, kInnerBand * step) + (0.25 + 1.0) * kCubeDiagonal * kCells * step + rounding;
  const bool at_once = std::isfinite(band) && !keeps_inside;
  quantum_ = static_cast<float>(most) / kMaxQuanta;
  const auto toQuanta = [&](float value) {
    const float quanta = value / quantum_;
    return static_cast<std::int16_t>(quanta + std::copysign(0.5f, quanta));
  };
  values_.resize(at_once ? kept.size() * kBlockValues : 0);
  std::vector<float> values(at_once ? 0 : kept.size() * kBlockValues);
  // fill(to) writes what a block measures itself.
  const auto store = [&](std::size_t n, auto&& fill) {
    if (!at_once) return fill(&values[n * kBlockValues]);
    std::array<float, kBlockValues> block{};
    fill(block.data());
    std::transform(block.begin(), block.end(), &values_[n * kBlockValues], toQuanta);
  };
  const auto neighboursOf = [&](std::size_t b) {
    const Vector3i place = cubes.placeOf(b);
    Neighbours neighbours;
    for (int c = 0; c < 8; ++c) {
      const Vector3i at = place + Vector3i(c & 1, c >> 1 & 1, c >> 2);
      const std::uint32_t block =
          (at.array() < cubes.size.array()).all() ? block_index_[cubes.indexOf(at)] : kNoBlock;
      neighbours.block[c >> 2][c >> 1 & 1][c & 1] = block == kDeepBlock ? kNoBlock : block;
    }
    return neighbours;
  };
  const auto* mesh = dynamic_cast<const geometry::MeshSurface*>(&surface);
  if (mesh == nullptr) {
    parallelFor(threads, kept.size(), [&](std::size_t n) {
      store(n, [&](float* to) {
        fillBlock(
            surface, neighboursOf(kept[n]), {blockOrigin(kept[n]), step, rounding},
            [&](const Vector3d& p, int, int, int, std::uint32_t hint) { return surface.closest(p, hint); },
            to);
      });
    });
  } else {
    const NearDistances distances(*mesh, origin, step);
    const auto isKept = [&](const Vector3i& block) {
      return block_index_[cubes.indexOf(block)] < kDeepBlock;
    };
    std::vector<Region> regions;
    std::uint32_t first_hint = geometry::kNoHint;
    const Region whole{Vector3i::Zero(), Vector3i(blocks_[0], blocks_[1], blocks_[2]), distances.all()};
    forRegions(distances, whole, kTogether, isKept, first_hint,
               [&](const Region& r) { regions.push_back(r); });
    parallelFor(threads, regions.size(), [&](std::size_t r) {
      std::uint32_t hint = geometry::kNoHint;
      const auto nearest = std::make_unique<geometry::SurfacePoint[][kVertices][kVertices]>(kVertices);
      forRegions(distances, regions[r], 1, isKept, hint, [&](const Region& block) {
        const std::size_t b = cubes.indexOf(block.first);
        const Neighbours neighbours = neighboursOf(b);
        measureBlock(distances, block, neighbours, hint, nearest.get());
        store(block_index_[b], [&](float* to) {
          fillBlock(
              surface, neighbours, {blockOrigin(b), step, rounding},
              [&](const Vector3d&, int i, int j, int k, std::uint32_t) { return nearest[k][j][i]; }, to);
        });
      });
      regions[r].list = {};
    });
  }
  // Owners are filled; what is read here was computed above and is written by none.
  parallelFor(threads, kept.size(), [&](std::size_t n) {
    if (at_once)
      copyFromOwners(neighboursOf(kept[n]), values_.data(), &values_[n * kBlockValues]);
    else
      copyFromOwners(neighboursOf(kept[n]), values.data(), &values[n * kBlockValues]);
  });

  if (!at_once) {
    float largest = std::numeric_limits<float>::min();
    for (const float value : values) largest = std::max(largest, std::abs(value));
    quantum_ = largest / kMaxQuanta;
    values_.resize(values.size());
    std::transform(values.begin(), values.end(), values_.begin(), toQuanta);
  }
  slope_ = steepest(threads);

  error_bound_ = 0.5 * kCubeDiagonal * step + 0.5 * double(quantum_) * kQuantized + rounding;
  const double margin = std::min((body.lower - origin).minCoeff(), (end - body.upper).minCoeff());
  band_ = std::max(0.0, std::min(band, margin) - rounding);
  deep_error_ = error_bound_;
  if (!keeps_inside && inside > 0.0) measureDeep(surface, cubes, rounding, threads);
}

// Of the trilinear function, each slope along an axis lies between those of a cell's four edges.
float NearField::steepest(int threads) const {
  std::vector<float> of_block(blocks(), 0.0f);
  parallelFor(threads, blocks(), [&](std::size_t b) {
    const std::int16_t* values = &values_[b * kBlockValues];
    std::int64_t most = 0;
    for (int k = 0; k < kCells; ++k) {
      for (int j = 0; j < kCells; ++j) {
        const auto row = [&](int i, int dj, int dk) {
          return EightValues(values + ((k + dk) * kVertices + j + dj) * kVertices + i);
        };
        EightSlopes x{}, y{}, z{};
        for (const auto& [p, q] : {std::pair{0, 0}, {0, 1}, {1, 0}, {1, 1}}) {
          x = larger(x, apart(row(1, p, q), row(0, p, q)));
          y = larger(y, apart(row(p, 1, q), row(p, 0, q)));
          z = larger(z, apart(row(p, q, 1), row(p, q, 0)));
        }
        for (int i = 0; i < kCells; ++i) {
          const auto square = [](std::int64_t v) { return v * v; };
          most = std::max(most, square(x[i]) + square(y[i]) + square(z[i]));
        }
      }
    }
    of_block[b] = std::sqrt(static_cast<float>(most));
  });
  const float most = of_block.empty() ? 0.0f : *std::max_element(of_block.begin(), of_block.end());
  return most * quantum_ * inv_h_ * kSlopeRounding;
}

NearField::View NearField::view() const {
  View v{};
  v.origin[0] = ox_;
  v.origin[1] = oy_;
  v.origin[2] = oz_;
  v.inv_h = inv_h_;
  for (int k = 0; k < 3; ++k) v.cells[k] = cells_[k];
  v.blocks[0] = blocks_[0];
  v.blocks[1] = blocks_[1];
  v.quantum = quantum_;
  v.error_bound = static_cast<float>(error_bound_);
  const auto h = static_cast<float>(grid_.voxel_size);
  v.h2 = h * h * kSlopeRounding;
  v.slope = slope_;
  v.band = static_cast<float>(band_);
  v.block_index = block_index_.data();
  v.values = values_.data();
  for (int k = 0; k < 2; ++k) v.deep_vertices[k] = blocks_[k] + 1;
  v.deep_quantum = deep_quantum_;
  v.deep_error = static_cast<float>(deep_error_);
  v.deep = deep_.empty() ? nullptr : deep_.data();
  return v;
}

bool NearField::sampleGradient(float px, float py, float pz, float& distance, float gradient[3]) const {
  const Cell cell = anyCellOf(px, py, pz);
  if (cell.values == nullptr) return false;
  const int row = cell.row, slice = cell.slice;
  const float x = cell.x, y = cell.y, z = cell.z;
  const auto v = [&cell](int i) { return static_cast<float>(cell.values[i]); };
  const float d00 = v(1) - v(0), d10 = v(row + 1) - v(row), d01 = v(slice + 1) - v(slice),
              d11 = v(slice + row + 1) - v(slice + row);
  const float a = v(0) + x * d00, b = v(row) + x * d10, c = v(slice) + x * d01, d = v(slice + row) + x * d11;
  const float near = a + y * (b - a), far = c + y * (d - c);
  const float dx_near = d00 + y * (d10 - d00), dx_far = d01 + y * (d11 - d01);
  const float scale = cell.quantum * cell.inv_h;
  distance = (near + z * (far - near)) * cell.quantum;
  gradient[0] = (dx_near + z * (dx_far - dx_near)) * scale;
  gradient[1] = ((b - a) + z * ((d - c) - (b - a))) * scale;
  gradient[2] = (far - near) * scale;
  return true;
}

std::size_t NearField::memoryBytes() const {
  return (values_.capacity() + deep_.capacity()) * sizeof(std::int16_t) +
         block_index_.capacity() * sizeof(std::uint32_t);
}

}  // namespace abstand::field
