// Farthest-point sampling of weighted surface samples: a sparse grid, and rounds with decreasing thresholds.
#include "core/shell/farthest_point_sampler.hpp"

#include <algorithm>
#include <bit>

namespace abstand::shell {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;
constexpr float kFarSample = std::numeric_limits<float>::max();
/// Factor of the threshold from one round to the next.
constexpr float kThresholdFactor = 0.97f;
/// With fewer cells the first centre is arbitrary; with more, the first centres come from one sample for each
/// cell.
constexpr std::size_t kFewCells = 64;
/// Edge of the coarse grid's cells, in cells of this grid.
constexpr float kCoarser = 4.0f;
/// Covering radius of the coarse centres, in coarse cells: their threshold and a reserve, as samples lie away
/// from the first one of their cell.
constexpr float kCoarseRadius = 1.5f;
constexpr int kBlockBits = 2, kBlockEdge = 1 << kBlockBits;
/// Largest number of cells along an axis; samples beyond go to the last one.
constexpr float kMaxCells = 1 << 20;

std::size_t hash(const Vector3i& at) {
  const auto u = [&](int k) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(at[k])); };
  std::uint64_t h = u(0) * 0x9e3779b97f4a7c15u ^ u(1) * 0xc2b2ae3d27d4eb4fu ^ u(2) * 0x165667b19e3779f9u;
  h ^= h >> 29;
  return static_cast<std::size_t>(h * 0xbf58476d1ce4e5b9u >> 20);
}

int bitOf(const Vector3i& cell) {
  return ((cell.z() & (kBlockEdge - 1)) * kBlockEdge + (cell.y() & (kBlockEdge - 1))) * kBlockEdge +
         (cell.x() & (kBlockEdge - 1));
}

/// Bit mask of the cells of block `at` that lie between `low` and `high`.
std::uint64_t bitsWithin(const Vector3i& at, const Vector3i& low, const Vector3i& high) {
  std::uint64_t along[3];
  for (int k = 0; k < 3; ++k) {
    const int first = std::max(0, low[k] - at[k] * kBlockEdge),
              last = std::min(kBlockEdge - 1, high[k] - at[k] * kBlockEdge);
    along[k] = (2u << last) - (1u << first);
  }
  const std::uint64_t y = (along[1] & 1) | (along[1] & 2) << 3 | (along[1] & 4) << 6 | (along[1] & 8) << 9;
  const std::uint64_t z = (along[2] & 1) | (along[2] & 2) << 15 | (along[2] & 4) << 30 | (along[2] & 8) << 45;
  // Copies the bits of x for every y, and the result for every z.
  return along[0] * y * z;
}

}  // namespace

void FarthestPointSampler::start(const std::vector<Sample>& samples, double cell,
                                 std::uint32_t first_centre) {
  cell_ = static_cast<float>(cell);
  per_cell_ = 1.0f / cell_;
  centres_.clear();
  first_centre_ = first_centre;
  sortIntoCells(samples);
}

Vector3i FarthestPointSampler::cellOf(const Vector3f& p) const {
  const Four from = Four{p.x() - lower_.x(), p.y() - lower_.y(), p.z() - lower_.z(), 0.0f} * per_cell_;
  const Four at = min(max(from, Four{}), splat(kMaxCells - 1.0f));
  const auto cell = __builtin_convertvector(at, FourInts);
  return {cell[0], cell[1], cell[2]};
}

const FarthestPointSampler::SparseBlock* FarthestPointSampler::blockAt(const Vector3i& at) const {
  for (std::size_t i = hash(at);; ++i) {
    const std::uint32_t block = block_table_[i & (block_table_.size() - 1)];
    if (block == kNone) return nullptr;
    if (blocks_[block].at == at) return &blocks_[block];
  }
}

std::uint32_t FarthestPointSampler::addBlock(const Vector3i& at) {
  const auto insert = [&](std::uint32_t block) {
    std::size_t i = hash(blocks_[block].at);
    while (block_table_[i & (block_table_.size() - 1)] != kNone) ++i;
    block_table_[i & (block_table_.size() - 1)] = block;
  };
  const auto block = static_cast<std::uint32_t>(blocks_.size());
  blocks_.push_back({at, 0, 0, {}});
  if (2 * blocks_.size() <= block_table_.size()) {
    insert(block);
  } else {
    block_table_.assign(std::max<std::size_t>(64, 2 * block_table_.size()), kNone);
    for (std::uint32_t b = 0; b <= block; ++b) insert(b);
  }
  return block;
}

inline void FarthestPointSampler::store(std::uint32_t at, const Sample& sample, float distance2) {
  Group& g = groups_[at / kLanes];
  const auto lane = at % kLanes;
  g.x[lane] = sample.position.x(), g.y[lane] = sample.position.y(), g.z[lane] = sample.position.z();
  g.nx[lane] = sample.normal.x(), g.ny[lane] = sample.normal.y(), g.nz[lane] = sample.normal.z();
  g.weight[lane] = sample.weight;
  g.distance2[lane] = distance2;
  g.nearest[lane] = 0.0f;
}

void FarthestPointSampler::sortIntoCells(const std::vector<Sample>& samples) {
  const std::size_t n = samples.size();
  blocks_.clear();
  lower_ = samples.front().position;
  for (const Sample& sample : samples) lower_ = lower_.cwiseMin(sample.position);

  // Blocks in the order of their first samples: neighbours in a mesh often are neighbours in space.
  cell_of_.resize(n);  // first block index times cells of a block, plus the bit
  constexpr std::uint32_t kCells = kBlockEdge * kBlockEdge * kBlockEdge;
  block_table_.assign(64, kNone);
  std::uint32_t block = kNone;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector3i cell = cellOf(samples[i].position),
                   at(cell.x() >> kBlockBits, cell.y() >> kBlockBits, cell.z() >> kBlockBits);
    if (block == kNone || blocks_[block].at != at) {
      const SparseBlock* existing = blockAt(at);
      block = existing != nullptr ? static_cast<std::uint32_t>(existing - blocks_.data()) : addBlock(at);
    }
    const int bit = bitOf(cell);
    blocks_[block].occupied |= std::uint64_t{1} << bit;
    cell_of_[i] = block * kCells + static_cast<std::uint32_t>(bit);
  }
  std::uint32_t cells = 0;
  for (SparseBlock& b : blocks_) {
    b.first = cells;
    std::uint8_t offset = 0;
    for (std::uint32_t bit = 0; bit < kCells; ++bit) {
      b.offset[bit] = offset;
      offset += (b.occupied >> bit) & 1u;
    }
    cells += offset;
  }

  // Counting sort; each cell is padded to whole groups.
  std::vector<std::uint32_t> next(cells, 0);
  for (std::uint32_t& c : cell_of_) {
    const SparseBlock& b = blocks_[c / kCells];
    c = b.first + b.offset[c % kCells];
    ++next[c];
  }
  cells_.resize(cells);
  std::uint32_t groups = 0;
  for (std::size_t c = 0; c < cells; ++c) {
    const std::uint32_t end = groups + (next[c] + kLanes - 1) / kLanes;
    cells_[c] = {splat(kFarSample), splat(-kFarSample), kFarSample, kFarSample, groups, end};
    next[c] = groups * kLanes;
    groups = end;
  }
  groups_.resize(groups);
  order_.assign(groups * kLanes, kNone);
  for (std::uint32_t i = 0; i < n; ++i) {
    const Sample& sample = samples[i];
    Cell& cell = cells_[cell_of_[i]];
    const Four p{sample.position.x(), sample.position.y(), sample.position.z(), 0.0f};
    cell.lower = min(cell.lower, p);
    cell.upper = max(cell.upper, p);
    cell.min_weight = std::min(cell.min_weight, sample.weight);
    const std::uint32_t at = next[cell_of_[i]]++;
    order_[at] = i;
    store(at, sample, kFarSample);
  }
  for (std::uint32_t c = 0; c < cells; ++c) {
    for (std::uint32_t at = next[c]; at < cells_[c].end * kLanes; ++at) store(at, sample(at - 1), -1.0f);
  }
}

Sample FarthestPointSampler::sample(std::uint32_t at) const {
  const Group& g = groups_[at / kLanes];
  const auto lane = at % kLanes;
  return {{g.x[lane], g.y[lane], g.z[lane]}, {g.nx[lane], g.ny[lane], g.nz[lane]}, g.weight[lane]};
}

void FarthestPointSampler::updateCell(Cell& cell, const Centre& centre) {
  const Four gap = max(max(cell.lower - centre.p, centre.p - cell.upper), Four{});
  if (sumOf(gap * gap) * cell.min_weight >= cell.farthest) return;
  const auto square = [](Four a) { return a * a; };
  Four farthest = splat(-1.0f);
  for (std::uint32_t i = cell.begin; i < cell.end; ++i) {
    Group& g = groups_[i];
    const Four d2 =
        g.weight * (square(g.x - centre.p[0]) + square(g.y - centre.p[1]) + square(g.z - centre.p[2]) +
                    square(g.nx - centre.n[0]) + square(g.ny - centre.n[1]) + square(g.nz - centre.n[2]));
    g.nearest = d2 < g.distance2 ? splat(centre.id) : g.nearest;
    g.distance2 = min(g.distance2, d2);
    farthest = max(farthest, g.distance2);
  }
  cell.farthest = largestOf(farthest);
}

void FarthestPointSampler::add(std::uint32_t id, const Vector3f& p, const Vector3f& n, float radius) {
  const Centre centre{std::bit_cast<float>(id), Four{p.x(), p.y(), p.z(), 0.0f}, n};
  const Vector3i low = cellOf(p.array() - radius), high = cellOf(p.array() + radius);
  const Vector3i first = low / kBlockEdge, last = high / kBlockEdge;
  if (((last - first).cast<double>().array() + 1.0).prod() > static_cast<double>(blocks_.size())) {
    for (Cell& cell : cells_) updateCell(cell, centre);
    return;
  }
  Vector3i at;
  for (at.z() = first.z(); at.z() <= last.z(); ++at.z()) {
    for (at.y() = first.y(); at.y() <= last.y(); ++at.y()) {
      for (at.x() = first.x(); at.x() <= last.x(); ++at.x()) {
        const SparseBlock* block = blockAt(at);
        if (block == nullptr) continue;
        for (std::uint64_t rest = block->occupied & bitsWithin(at, low, high); rest != 0; rest &= rest - 1)
          updateCell(cells_[block->first + block->offset[std::countr_zero(rest)]], centre);
      }
    }
  }
}

void FarthestPointSampler::addSample(std::uint32_t at, float radius, float distance2) {
  const Sample centre = sample(at);
  const auto id = first_centre_ + static_cast<std::uint32_t>(centres_.size());
  centres_.push_back({at, distance2});
  add(id, centre.position, centre.normal, radius);
}

void FarthestPointSampler::offer(std::uint32_t centre, const Vector3f& point, const Vector3f& normal,
                                 double radius) {
  add(centre, point, normal, static_cast<float>(radius));
}

std::uint32_t FarthestPointSampler::farthestOf(const Cell& cell) const {
  float farthest = -1.0f;
  std::uint32_t at = 0;
  for (std::uint32_t i = cell.begin * kLanes; i < cell.end * kLanes; ++i) {
    const float d2 = groups_[i / kLanes].distance2[i % kLanes];
    if (d2 > farthest) farthest = d2, at = i;
  }
  return at;
}

void FarthestPointSampler::lowerThreshold(float from, float radius) {
  for (float threshold = std::max(from, radius), previous = threshold;;
       previous = threshold, threshold = std::max(kThresholdFactor * threshold, radius)) {
    const float threshold2 = threshold * threshold;
    for (Cell& cell : cells_) {
      while (cell.farthest > threshold2) addSample(farthestOf(cell), previous, cell.farthest);
    }
    if (threshold <= radius) return;
  }
}

void FarthestPointSampler::selectCentres(double radius) {
  if (cells_.size() <= kFewCells) {
    for (Cell& cell : cells_) {
      while (cell.farthest == kFarSample) addSample(farthestOf(cell), kFarSample, kFarSample);
    }
    fillHoles(radius);
    return;
  }
  std::vector<Sample> first_samples;
  first_samples.reserve(cells_.size());
  for (const Cell& cell : cells_) first_samples.push_back(sample(cell.begin * kLanes));
  const float coarse_cell = kCoarser * cell_, radius2 = static_cast<float>(radius * radius);
  FarthestPointSampler coarse;
  coarse.start(first_samples, double(coarse_cell));
  coarse.selectCentres(double(coarse_cell));
  // Each coarse sample is the first sample of a cell. It may already be near an offered centre.
  for (const Selected& selected : coarse.centres_) {
    const std::uint32_t at = cells_[coarse.order_[selected.at]].begin * kLanes;
    if (groups_[at / kLanes].distance2[at % kLanes] > radius2)
      addSample(at, kCoarseRadius * coarse_cell, selected.distance2);
  }
  lowerThreshold(coarse_cell, static_cast<float>(radius));
}

float FarthestPointSampler::farthest2() const {
  float farthest = 0.0f;
  for (const Cell& cell : cells_) farthest = std::max(farthest, cell.farthest);
  return farthest;
}

void FarthestPointSampler::fillHoles(double radius) {
  lowerThreshold(std::sqrt(farthest2()), static_cast<float>(radius));
}

void FarthestPointSampler::restart(std::span<const std::uint32_t> nearest,
                                   const std::vector<Vector3f>& points, const std::vector<Vector3f>& normals,
                                   std::uint32_t first_centre) {
  centres_.clear();
  first_centre_ = first_centre;
  for (Cell& cell : cells_) {
    cell.farthest = -1.0f;
    for (std::uint32_t i = cell.begin * kLanes; i < cell.end * kLanes; ++i) {
      if (order_[i] == kNone) continue;
      const std::uint32_t lane = i % kLanes, centre = nearest[order_[i]];
      const Sample from = sample(i);
      const float d2 = from.weight * ((points[centre] - from.position).squaredNorm() +
                                      (normals[centre] - from.normal).squaredNorm());
      groups_[i / kLanes].nearest[lane] = std::bit_cast<float>(centre);
      groups_[i / kLanes].distance2[lane] = d2;
      cell.farthest = std::max(cell.farthest, d2);
    }
  }
}

std::vector<FarthestPointSampler::Found> FarthestPointSampler::found() const {
  std::vector<Found> out;
  out.reserve(centres_.size());
  for (const Selected& selected : centres_) out.push_back({sample(selected.at), selected.distance2});
  return out;
}

void FarthestPointSampler::nearest(std::span<std::uint32_t> out) const {
  for (std::size_t i = 0; i < order_.size(); ++i) {
    if (order_[i] == kNone) continue;
    const float id = groups_[i / kLanes].nearest[i % kLanes];
    out[order_[i]] = std::bit_cast<std::uint32_t>(id);
  }
}

}  // namespace abstand::shell
