#include "core/margin/clearance_store.hpp"

#include <algorithm>

namespace abstand::margin {
namespace {

constexpr std::size_t kFrames = ClearanceChunk::kFrames, kBlock = ClearanceChunk::kBlock;

}  // namespace

void ClearanceStore::add(std::shared_ptr<const ClearanceChunk> chunk) {
  frames_ += chunk->frames();
  chunks_.push_back(std::move(chunk));
}

double ClearanceStore::t(std::size_t frame) const { return chunks_[frame / kFrames]->t(frame % kFrames); }

std::size_t ClearanceStore::frameAt(double t) const {
  std::size_t low = 0, high = frames_;
  while (low + 1 < high) {
    const std::size_t middle = (low + high) / 2;
    (this->t(middle) <= t ? low : high) = middle;
  }
  return low;
}

ClearanceChunk::Nearest ClearanceStore::nearest(std::size_t part, std::size_t frame) const {
  return chunks_[frame / kFrames]->nearest(part, frame % kFrames);
}

ClearanceStore::Look ClearanceStore::look(std::size_t part, std::size_t begin, std::size_t end) const {
  Look look;
  look.unknown = end > frames_;
  end = std::min(end, frames_);
  for (std::size_t i = begin; i < end;) {
    const ClearanceChunk& chunk = *chunks_[i / kFrames];
    const std::size_t in_chunk = i % kFrames;
    const std::size_t here = std::min(end - i, chunk.frames() - in_chunk);
    const ClearanceChunk::Summary& all = chunk.summary(part);
    if (here == chunk.frames() && !all.unknown) {
      look.least = std::min(look.least, all.least);
      i += here;
      continue;
    }
    for (std::size_t j = in_chunk; j < in_chunk + here;) {
      const std::size_t rest = in_chunk + here - j;
      if (j % kBlock == 0 && rest >= kBlock && (!all.unknown || look.unknown)) {
        look.least = std::min(look.least, chunk.blockMinimum(part, j / kBlock));
        j += kBlock;
        continue;
      }
      if (chunk.unknown(part, j))
        look.unknown = true;
      else
        look.least = std::min(look.least, chunk.clearance(part, j));
      ++j;
    }
    i += here;
  }
  return look;
}

std::size_t ClearanceStore::leastFrame(std::size_t part, std::size_t begin, std::size_t end) const {
  std::size_t least = begin;
  double best = kInfinity;
  for (std::size_t i = begin; i < end;) {
    const ClearanceChunk& chunk = *chunks_[i / kFrames];
    const std::size_t in_chunk = i % kFrames;
    const std::size_t here = std::min(end - i, chunk.frames() - in_chunk);
    if (chunk.summary(part).least < best)
      for (std::size_t j = in_chunk; j < in_chunk + here; ++j)
        if (chunk.clearance(part, j) < best) best = chunk.clearance(part, j), least = i + j - in_chunk;
    i += here;
  }
  return least;
}

std::size_t ClearanceStore::bytes() const {
  std::size_t sum = 0;
  for (const auto& chunk : chunks_) sum += chunk->bytes();
  return sum;
}

}  // namespace abstand::margin
