// Farthest-point sampling of the sub-triangles, chunk by chunk.
#include "core/shell/shell_sampler.hpp"

#include <algorithm>
#include <numeric>

#include "core/base/parallel.hpp"

namespace abstand::shell {
namespace {

/// Largest number of sub-triangles in a chunk: some 5 MB of samples.
constexpr std::uint32_t kStretch = 1u << 16;
/// Width of the border, in multiples of `reach`, within which centres outside of a chunk are considered.
constexpr double kBorder = 2.0;

}  // namespace

ShellSampler::ShellSampler(const SubTriangles& pool, const std::vector<float>& density, double normal_length,
                           double cell)
    : pool_(pool), density_(density), normal_length_(normal_length), cell_(cell), nearest_(pool.size()) {
  const std::uint32_t n = pool.size(), count = (n + kStretch - 1) / kStretch;
  for (std::uint32_t s = 0; s < count; ++s) {
    const auto at = [&](std::uint32_t i) { return static_cast<std::uint32_t>(std::uint64_t{n} * i / count); };
    stretches_.push_back({at(s), at(s + 1), 0, emptyBox()});
  }
}

ShellSampler::Box ShellSampler::emptyBox() {
  constexpr float kFar = std::numeric_limits<float>::infinity();
  return {Vector3f::Constant(kFar), Vector3f::Constant(-kFar)};
}

void ShellSampler::take(Stretch& stretch) {
  if (taken_ == &stretch) return;
  taken_ = &stretch;
  samples_.clear();
  pool_.walk(stretch.first, stretch.end, [&](std::uint32_t i, const SubTriangles::View& piece) {
    samples_.push_back({piece.centroid().cast<float>(),
                        (normal_length_ * pool_.normal(piece.triangle())).cast<float>(), density_[i]});
  });
  if (stretch.box.lower.x() > stretch.box.upper.x()) {
    for (const Sample& sample : samples_) stretch.box.enclose(sample.position);
  }
  cover_.start(samples_, cell_, count());
}

bool ShellSampler::isNear(std::uint32_t centre, const Stretch& stretch, double reach) const {
  return used_[centre] && stretch.box.isWithin(static_cast<float>(reach), {points_[centre], points_[centre]});
}

void ShellSampler::offer(const Stretch& stretch, const Batch& batch, double reach) {
  if (!batch.box.isWithin(static_cast<float>(reach), stretch.box)) return;
  for (std::uint32_t k = batch.first; k < batch.end; ++k) {
    if (isNear(k, stretch, reach)) cover_.offer(k, points_[k], normals_[k], reach);
  }
}

void ShellSampler::keep(Stretch& stretch, bool filling) {
  cover_.nearest(nearestOf(stretch));
  Batch batch{count(), count(), emptyBox()};
  for (const FarthestPointSampler::Found& found : cover_.found()) {
    points_.push_back(found.sample.position);
    normals_.push_back(found.sample.normal);
    found_at2_.push_back(filling ? -1.0f : found.distance2);
    batch.box.enclose(points_.back());
  }
  batch.end = count();
  used_.resize(count(), true);
  batches_.push_back(batch);
  stretch.known = static_cast<std::uint32_t>(batches_.size());
}

std::vector<std::uint32_t> ShellSampler::order() const {
  std::vector<std::uint32_t> order(count());
  std::iota(order.begin(), order.end(), 0u);
  if (stretches_.size() > 1) {
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t k, std::uint32_t l) { return found_at2_[k] > found_at2_[l]; });
  }
  return order;
}

void ShellSampler::catchUp(double reach) {
  for (Stretch& stretch : stretches_) {
    for (; stretch.known < batches_.size(); ++stretch.known) {
      const Batch& batch = batches_[stretch.known];
      if (!batch.box.isWithin(static_cast<float>(reach), stretch.box)) continue;
      if (taken_ != &stretch) {
        std::uint32_t k = batch.first;
        while (k < batch.end && !isNear(k, stretch, reach)) ++k;
        if (k == batch.end) continue;
        take(stretch);
        cover_.restart(nearestOf(stretch), points_, normals_, count());
      }
      offer(stretch, batch, reach);
    }
    if (taken_ == &stretch) cover_.nearest(nearestOf(stretch));
  }
}

// Serial, but through parallelFor, so that LoopWatch can interrupt it.
template <class Fn>
void ShellSampler::inTurn(Fn fn) {
  parallelFor(1, stretches_.size(), [&](std::size_t i) { fn(stretches_[i]); });
}

void ShellSampler::spread(double reach) {
  inTurn([&](Stretch& stretch) {
    take(stretch);
    for (const Batch& batch : batches_) offer(stretch, batch, kBorder * reach);
    cover_.spread(reach);
    keep(stretch, false);
  });
  catchUp(reach);
}

void ShellSampler::fill(std::vector<Vector3f> points, std::vector<Vector3f> normals, double reach) {
  points_ = std::move(points);
  normals_ = std::move(normals);
  used_.assign(count(), false);
  for (const std::uint32_t k : nearest_) used_[k] = true;
  for (Batch& batch : batches_) {
    batch.box = emptyBox();
    for (std::uint32_t k = batch.first; k < batch.end; ++k) {
      if (used_[k]) batch.box.enclose(points_[k]);
    }
  }
  inTurn([&](Stretch& stretch) {
    take(stretch);
    cover_.restart(nearestOf(stretch), points_, normals_, count());
    for (const Batch& batch : batches_) offer(stretch, batch, reach);
    cover_.fill(reach);
    keep(stretch, true);
  });
  catchUp(reach);
}

}  // namespace abstand::shell
