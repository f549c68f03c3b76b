#include "core/haptic/far_field.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"

namespace abstand {
namespace {

constexpr double kFirstPad = 2.0;        // cells of the first grid beyond the body
constexpr float kRoundDown = 0.999999f;  // what float interpolation and the root may add

}  // namespace

FarField::FarField(const Surface& surface, double first_spacing, double reach, int threads) {
  const Bounds box = surface.bounds();
  double h = first_spacing, pad = kFirstPad * h;
  while (true) {
    Level level;
    level.h = static_cast<float>(h);
    level.inv_h = 1.0f / level.h;
    const Eigen::Vector3f first = (box.lower.array() - pad).cast<float>();
    level.ox = first.x();
    level.oy = first.y();
    level.oz = first.z();
    for (int i = 0; i < 3; ++i)
      level.n[i] =
          static_cast<int>(std::ceil((box.extent()[i] + 2.0 * pad) / static_cast<double>(level.h))) + 2;
    level.d2.resize(static_cast<std::size_t>(level.n[0]) * level.n[1] * level.n[2]);
    // One row along x at a time: neighbours share their nearest triangle.
    parallelFor(threads, static_cast<std::size_t>(level.n[1]) * level.n[2], [&](std::size_t row) {
      const auto j = static_cast<double>(row % level.n[1]), k = static_cast<double>(row / level.n[1]);
      const double y = level.oy + j * level.h, z = level.oz + k * level.h;
      std::uint32_t hint = kNoHint;
      float* out = &level.d2[row * level.n[0]];
      for (int i = 0; i < level.n[0]; ++i) {
        const SurfacePoint nearest =
            surface.closest(Vector3d(level.ox + i * static_cast<double>(level.h), y, z), hint);
        hint = nearest.hint;
        out[i] = std::nextafter(static_cast<float>(nearest.distance * nearest.distance), 0.0f);
      }
    });
    levels_.push_back(std::move(level));
    if (pad >= reach) break;
    h *= 2.0;
    pad = 2.0 * pad + 2.0 * h;
  }
  const Level& last = levels_.back();
  const float origin[3] = {last.ox, last.oy, last.oz};
  for (int i = 0; i < 3; ++i) {
    box_lo_[i] = origin[i];
    box_hi_[i] = origin[i] + static_cast<float>(last.n[i] - 1) * last.h;
  }
  // Every face of the last grid is at least its pad away from the body's bounds.
  boundary_min_ = static_cast<float>(pad) * kRoundDown;
}

float FarField::lowerBound(float px, float py, float pz) const {
  for (const Level& level : levels_) {
    const float x = (px - level.ox) * level.inv_h, y = (py - level.oy) * level.inv_h,
                z = (pz - level.oz) * level.inv_h;
    // Written so that NaN fails.
    if (!(x >= 0.0f && y >= 0.0f && z >= 0.0f && x < static_cast<float>(level.n[0] - 1) &&
          y < static_cast<float>(level.n[1] - 1) && z < static_cast<float>(level.n[2] - 1)))
      continue;
    const int i = static_cast<int>(x), j = static_cast<int>(y), k = static_cast<int>(z);
    const float u = x - static_cast<float>(i), v = y - static_cast<float>(j), w = z - static_cast<float>(k);
    const std::size_t row = static_cast<std::size_t>(level.n[0]), slab = row * level.n[1];
    const float* c = &level.d2[k * slab + j * row + i];
    const auto along = [u](const float* p) { return p[0] + u * (p[1] - p[0]); };
    const float near = along(c) + v * (along(c + row) - along(c));
    const float far = along(c + slab) + v * (along(c + slab + row) - along(c + slab));
    const float curvature = level.h * level.h * (u * (1.0f - u) + v * (1.0f - v) + w * (1.0f - w));
    const float d2 = near + w * (far - near) - curvature;
    return d2 > 0.0f ? std::sqrt(d2) * kRoundDown : 0.0f;
  }
  const float p[3] = {px, py, pz};
  float square = 0.0f;
  for (int i = 0; i < 3; ++i) {
    const float out = std::max({box_lo_[i] - p[i], p[i] - box_hi_[i], 0.0f});
    square += out * out;
  }
  // A position that is not a number proves nothing.
  return std::isfinite(square) ? std::sqrt(square) * kRoundDown + boundary_min_ : 0.0f;
}

std::size_t FarField::memoryBytes() const {
  std::size_t bytes = 0;
  for (const Level& level : levels_) bytes += level.d2.size() * sizeof(float);
  return bytes;
}

}  // namespace abstand
