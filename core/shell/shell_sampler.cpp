// Farthest-point sampling of the sub-triangles, chunk by chunk.
#include "core/shell/shell_sampler.hpp"

#include <algorithm>
#include <numeric>

#include "core/base/parallel.hpp"

namespace abstand::shell {
namespace {

/// Largest number of sub-triangles in a chunk: some 5 MB of samples.
constexpr std::uint32_t kChunkSize = 1u << 16;
/// Width of the border, in multiples of `radius`, within which centres outside of a chunk are considered.
constexpr double kBorder = 2.0;

}  // namespace

ShellSampler::ShellSampler(const SubTriangles& pool, const std::vector<float>& density, double normal_length,
                           double cell)
    : pool_(pool), density_(density), normal_length_(normal_length), cell_(cell), nearest_(pool.size()) {
  const std::uint32_t n = pool.size(), count = (n + kChunkSize - 1) / kChunkSize;
  for (std::uint32_t s = 0; s < count; ++s) {
    const auto at = [&](std::uint32_t i) { return static_cast<std::uint32_t>(std::uint64_t{n} * i / count); };
    chunks_.push_back({at(s), at(s + 1), 0, emptyBox()});
  }
}

ShellSampler::Box ShellSampler::emptyBox() {
  constexpr float kFar = std::numeric_limits<float>::infinity();
  return {Vector3f::Constant(kFar), Vector3f::Constant(-kFar)};
}

void ShellSampler::loadSamples(Chunk& chunk) {
  if (loaded_ == &chunk) return;
  loaded_ = &chunk;
  samples_.clear();
  pool_.forEach(chunk.first, chunk.end, [&](std::uint32_t i, const SubTriangles::View& piece) {
    samples_.push_back({piece.centroid().cast<float>(),
                        (normal_length_ * pool_.normal(piece.triangle())).cast<float>(), density_[i]});
  });
  if (chunk.box.lower.x() > chunk.box.upper.x()) {
    for (const Sample& sample : samples_) chunk.box.enclose(sample.position);
  }
  sampler_.start(samples_, cell_, count());
}

bool ShellSampler::isNear(std::uint32_t centre, const Chunk& chunk, double radius) const {
  return used_[centre] && chunk.box.isWithin(static_cast<float>(radius), {points_[centre], points_[centre]});
}

void ShellSampler::offer(const Chunk& chunk, const Batch& batch, double radius) {
  if (!batch.box.isWithin(static_cast<float>(radius), chunk.box)) return;
  for (std::uint32_t k = batch.first; k < batch.end; ++k) {
    if (isNear(k, chunk, radius)) sampler_.offer(k, points_[k], normals_[k], radius);
  }
}

void ShellSampler::storeResults(Chunk& chunk, bool filling) {
  sampler_.nearest(nearestOf(chunk));
  Batch batch{count(), count(), emptyBox()};
  for (const FarthestPointSampler::Found& found : sampler_.found()) {
    points_.push_back(found.sample.position);
    normals_.push_back(found.sample.normal);
    found_at2_.push_back(filling ? -1.0f : found.distance2);
    batch.box.enclose(points_.back());
  }
  batch.end = count();
  used_.resize(count(), true);
  batches_.push_back(batch);
  chunk.offered_batches = static_cast<std::uint32_t>(batches_.size());
}

std::vector<std::uint32_t> ShellSampler::order() const {
  std::vector<std::uint32_t> order(count());
  std::iota(order.begin(), order.end(), 0u);
  if (chunks_.size() > 1) {
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t k, std::uint32_t l) { return found_at2_[k] > found_at2_[l]; });
  }
  return order;
}

void ShellSampler::offerLaterCentres(double radius) {
  for (Chunk& chunk : chunks_) {
    for (; chunk.offered_batches < batches_.size(); ++chunk.offered_batches) {
      const Batch& batch = batches_[chunk.offered_batches];
      if (!batch.box.isWithin(static_cast<float>(radius), chunk.box)) continue;
      if (loaded_ != &chunk) {
        std::uint32_t k = batch.first;
        while (k < batch.end && !isNear(k, chunk, radius)) ++k;
        if (k == batch.end) continue;
        loadSamples(chunk);
        sampler_.restart(nearestOf(chunk), points_, normals_, count());
      }
      offer(chunk, batch, radius);
    }
    if (loaded_ == &chunk) sampler_.nearest(nearestOf(chunk));
  }
}

// Serial, but through parallelFor, so that LoopWatch can interrupt it.
template <class Fn>
void ShellSampler::forEachChunk(Fn fn) {
  parallelFor(1, chunks_.size(), [&](std::size_t i) { fn(chunks_[i]); });
}

void ShellSampler::selectCentres(double radius) {
  forEachChunk([&](Chunk& chunk) {
    loadSamples(chunk);
    for (const Batch& batch : batches_) offer(chunk, batch, kBorder * radius);
    sampler_.selectCentres(radius);
    storeResults(chunk, false);
  });
  offerLaterCentres(radius);
}

void ShellSampler::fillHoles(std::vector<Vector3f> points, std::vector<Vector3f> normals, double radius) {
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
  forEachChunk([&](Chunk& chunk) {
    loadSamples(chunk);
    sampler_.restart(nearestOf(chunk), points_, normals_, count());
    for (const Batch& batch : batches_) offer(chunk, batch, radius);
    sampler_.fillHoles(radius);
    storeResults(chunk, true);
  });
  offerLaterCentres(radius);
}

}  // namespace abstand::shell
