// Distances away from a body, certified from below.
#include "core/haptic/far_field.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "core/base/parallel.hpp"

namespace abstand {
namespace {

constexpr double kMostVertices = 5e7;
constexpr float kEpsilon = 0x1p-23f;
// Relative: the squared distances' rounding, and that of a sum of eight products with their weights.
constexpr double kStored = 4.0 * kEpsilon;
constexpr float kSummed = 16.0f * kEpsilon;

}  // namespace

FarField::FarField(const Surface& surface, double first_spacing, double reach, int threads) {
  const Bounds body = surface.bounds();
  double h = first_spacing;
  double margin = 0.0;
  for (bool wide_enough = false; !wide_enough; h *= 2.0) {
    margin = kMargin * h;
    wide_enough = margin >= reach;
    Level level;
    const Vector3d cells = ((body.extent().array() + 2.0 * margin) / h).ceil();
    if (!((cells.array() + 1.0).prod() <= kMostVertices)) {
      throw UsageError("the voxel size is far too small for the size of the body");
    }
    const Vector3d origin = body.centre() - 0.5 * h * cells;
    level.ox = static_cast<float>(origin.x());
    level.oy = static_cast<float>(origin.y());
    level.oz = static_cast<float>(origin.z());
    level.h = static_cast<float>(h);
    level.inv_h = static_cast<float>(1.0 / h);
    level.rounding =
        8.0f * kEpsilon * static_cast<float>(origin.cwiseAbs().maxCoeff() + h * cells.maxCoeff());
    for (int k = 0; k < 3; ++k) level.n[k] = static_cast<int>(cells[k]) + 1;
    level.d2.resize(std::size_t(level.n[0]) * level.n[1] * level.n[2]);
    levels_.push_back(std::move(level));
  }
  fill(surface, threads);

  const Level& last = levels_.back();
  const float origin[3] = {last.ox, last.oy, last.oz};
  for (int k = 0; k < 3; ++k) {
    box_lo_[k] = origin[k];
    box_hi_[k] = origin[k] + last.h * static_cast<float>(last.n[k] - 1);
  }
  // On a face of the boundary the interpolation of the squares loses at most h^2 / 2.
  float least = std::numeric_limits<float>::max();
  std::size_t v = 0;
  for (int k = 0; k < last.n[2]; ++k) {
    for (int j = 0; j < last.n[1]; ++j) {
      for (int i = 0; i < last.n[0]; ++i, ++v) {
        const bool rim =
            i == 0 || j == 0 || k == 0 || i + 1 == last.n[0] || j + 1 == last.n[1] || k + 1 == last.n[2];
        if (rim) least = std::min(least, last.d2[v]);
      }
    }
  }
  const float on_face = std::sqrt(std::max(0.0f, least - 0.5f * last.h * last.h));
  boundary_min_ =
      std::max(0.0f, std::max(on_face, static_cast<float>(margin)) * (1.0f - kSummed) - last.rounding);
}

void FarField::fill(const Surface& surface, int threads) {
  struct Slice {
    Level* level;
    int k;
  };
  std::vector<Slice> slices;
  for (Level& level : levels_) {
    for (int k = 0; k < level.n[2]; ++k) slices.push_back({&level, k});
  }
  parallelFor(threads, slices.size(), [&](std::size_t s) {
    Level& level = *slices[s].level;
    std::uint32_t hint = kNoHint;
    for (int j = 0; j < level.n[1]; ++j) {
      const std::size_t row = (std::size_t(slices[s].k) * level.n[1] + j) * level.n[0];
      for (int step = 0; step < level.n[0]; ++step) {
        // Back and forth, so that the hint is always a neighbour's.
        const int i = j % 2 == 0 ? step : level.n[0] - 1 - step;
        const Vector3d p(double(level.ox) + double(level.h) * i, double(level.oy) + double(level.h) * j,
                         double(level.oz) + double(level.h) * slices[s].k);
        const SurfacePoint nearest = surface.closest(p, hint);
        hint = nearest.hint;
        level.d2[row + i] = static_cast<float>(nearest.distance * nearest.distance * (1.0 - kStored));
      }
    }
  });
}

float FarField::interpolate(const Level& level, float gx, float gy, float gz) {
  // The last vertex belongs to the cell before it.
  const int i = std::min(static_cast<int>(gx), level.n[0] - 2);
  const int j = std::min(static_cast<int>(gy), level.n[1] - 2);
  const int k = std::min(static_cast<int>(gz), level.n[2] - 2);
  const float x = gx - static_cast<float>(i), y = gy - static_cast<float>(j), z = gz - static_cast<float>(k);
  const std::size_t nx = level.n[0], nxy = nx * level.n[1];
  const float* v = &level.d2[k * nxy + j * nx + i];
  const auto along = [x](const float* p) { return p[0] + x * (p[1] - p[0]); };
  const float y0 = along(v) + y * (along(v + nx) - along(v));
  const float y1 = along(v + nxy) + y * (along(v + nxy + nx) - along(v + nxy));
  const float sum = y0 + z * (y1 - y0);
  const float h2 = level.h * level.h;
  const float loss = h2 * (x * (1.0f - x) + y * (1.0f - y) + z * (1.0f - z));
  const float d2 = sum - loss - kSummed * (sum + 4.0f * h2);
  return d2 > 0.0f ? std::max(0.0f, std::sqrt(d2) - level.rounding) : 0.0f;
}

float FarField::lowerBound(float px, float py, float pz) const {
  for (const Level& level : levels_) {
    const float gx = (px - level.ox) * level.inv_h, gy = (py - level.oy) * level.inv_h,
                gz = (pz - level.oz) * level.inv_h;
    // Written so that NaN fails.
    if (gx >= 0.0f && gy >= 0.0f && gz >= 0.0f && gx <= static_cast<float>(level.n[0] - 1) &&
        gy <= static_cast<float>(level.n[1] - 1) && gz <= static_cast<float>(level.n[2] - 1)) {
      return interpolate(level, gx, gy, gz);
    }
  }
  const float dx = std::max({box_lo_[0] - px, px - box_hi_[0], 0.0f});
  const float dy = std::max({box_lo_[1] - py, py - box_hi_[1], 0.0f});
  const float dz = std::max({box_lo_[2] - pz, pz - box_hi_[2], 0.0f});
  const float beyond = std::sqrt(dx * dx + dy * dy + dz * dz) * (1.0f - kSummed) + boundary_min_;
  return std::isfinite(beyond) && px == px && py == py && pz == pz ? beyond : 0.0f;
}

std::size_t FarField::memoryBytes() const {
  std::size_t bytes = levels_.capacity() * sizeof(Level);
  for (const Level& level : levels_) bytes += level.d2.capacity() * sizeof(float);
  return bytes;
}

}  // namespace abstand
