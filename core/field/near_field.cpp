// Signed distance field near the surface.
#include "core/field/near_field.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "core/base/parallel.hpp"
#include "core/field/field_quanta.hpp"
#include "core/field/near_samples.hpp"

namespace abstand::field {
namespace {

constexpr double kFloatEpsilon = 0x1p-23;
constexpr float kSlopeRounding = 1.0f + 1e-5f;

// A row of a block's values, and the differences of two rows, as a vector.
using EightNumbers [[gnu::vector_size(16)]] = std::int16_t;
using EightSlopes [[gnu::vector_size(16)]] = std::uint16_t;
struct EightValues {
  explicit EightValues(const std::int16_t* p) { std::memcpy(&v, p, sizeof v); }
  EightNumbers v;
};
static_assert(sizeof(EightNumbers) == NearField::kCells * sizeof(std::int16_t));
EightSlopes apart(const EightValues& a, const EightValues& b) {
  const auto p = reinterpret_cast<EightSlopes>(a.v), q = reinterpret_cast<EightSlopes>(b.v);
  return a.v > b.v ? p - q : q - p;
}
EightSlopes larger(EightSlopes a, EightSlopes b) { return a > b ? a : b; }

// Rounding moves a point and its values by a few ulps of the coordinates; values of a mesh were computed in
// float relative to its middle.
double roundingIn(const BlockGrid& grid) {
  const Vector3d end = grid.end();
  return 8.0 * kFloatEpsilon *
         (grid.origin.cwiseAbs().cwiseMax(end.cwiseAbs()).maxCoeff() + 2.0 * (end - grid.origin).norm());
}

}  // namespace

NearField::NearField(const geometry::Surface& surface, const VoxelGrid& grid, double band, int threads,
                     std::size_t whole_inside)
    : grid_(grid) {
  const BlockGrid cubes = setUpGrid();
  const double rounding = roundingIn(cubes);
  SelectedBlocks kept = selectBlocks(surface, cubes, {band, whole_inside}, threads);
  measure(surface, kept, {band, rounding}, threads);
  block_index_ = std::move(kept.index);
  slope_ = steepest(threads);

  error_bound_ = 0.5 * kCubeDiagonal * cubes.voxel + 0.5 * double(quantum_) * kQuantized + rounding;
  const geometry::Bounds body = surface.bounds();
  const double margin =
      std::min((body.lower - cubes.origin).minCoeff(), (cubes.end() - body.upper).minCoeff());
  band_ = std::max(0.0, std::min(band, margin) - rounding);
  deep_error_ = error_bound_;
  if (kept.any_deep) measureDeep(surface, cubes, rounding, threads);
}

// Vertices at the positions that sample() assumes.
BlockGrid NearField::setUpGrid() {
  const double h = grid_.voxel_size;
  const Vector3d corner = grid_.first_centre.array() - 0.5 * h;
  ox_ = static_cast<float>(corner.x());
  oy_ = static_cast<float>(corner.y());
  oz_ = static_cast<float>(corner.z());
  inv_h_ = static_cast<float>(1.0 / h);
  for (int k = 0; k < 3; ++k) {
    blocks_[k] = (grid_.size[k] + kCells - 1) / kCells;
    cells_[k] = static_cast<float>(blocks_[k] * kCells);
  }
  return {Vector3d(ox_, oy_, oz_), 1.0 / double(inv_h_), Vector3i(blocks_[0], blocks_[1], blocks_[2])};
}

// A sparse field's distances have a known limit, so each block is quantised as soon as it is computed and no
// floats are stored: a block near the surface contains a cube of half its width whose centre is no farther
// than the band plus that cube's half diagonal. Otherwise the largest distance decides.
void NearField::measure(const geometry::Surface& surface, const SelectedBlocks& kept,
                        const Precision& precision, int threads) {
  const auto& [band, rounding] = precision;
  if (std::isfinite(band) && !kept.all_inside) {
    const double step = kept.grid.voxel;
    const double largest =
        std::max(band, kInnerBand * step) + (0.25 + 1.0) * kCubeDiagonal * kCells * step + rounding;
    quantum_ = static_cast<float>(largest) / kMaxQuanta;
    values_ = sampleQuanta(surface, kept, rounding, quantum_, threads);
    return;
  }
  const std::vector<float> values = sampleBlocks(surface, kept, rounding, threads);
  float largest = std::numeric_limits<float>::min();
  for (const float value : values) largest = std::max(largest, std::abs(value));
  quantum_ = largest / kMaxQuanta;
  values_.resize(values.size());
  std::transform(values.begin(), values.end(), values_.begin(),
                 [&](float value) { return toQuanta(value, quantum_); });
}

// Upper bound of the gradient: each partial derivative of a trilinear function lies between the slopes of a
// cell's four edges.
float NearField::steepest(int threads) const {
  std::vector<float> of_block(blocks(), 0.0f);
  parallelFor(threads, blocks(), [&](std::size_t b) {
    const std::int16_t* values = &values_[b * kBlockValues];
    std::int64_t largest = 0;
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
          largest = std::max(largest, square(x[i]) + square(y[i]) + square(z[i]));
        }
      }
    }
    of_block[b] = std::sqrt(static_cast<float>(largest));
  });
  const float largest = of_block.empty() ? 0.0f : *std::max_element(of_block.begin(), of_block.end());
  return largest * quantum_ * inv_h_ * kSlopeRounding;
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
