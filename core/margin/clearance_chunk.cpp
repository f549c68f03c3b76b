#include "core/margin/clearance_chunk.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::margin {
namespace {

float floatBelow(double value) {
  const auto nearest = static_cast<float>(value);
  return static_cast<double>(nearest) > value ? std::nextafter(nearest, -static_cast<float>(kInfinity))
                                              : nearest;
}

}  // namespace

ClearanceChunk::ClearanceChunk(const StoreLayout& layout, std::vector<double> t,
                               std::span<const PairSample> samples, std::size_t judged)
    : t_(std::move(t)), judged_(judged) {
  for (std::size_t k = 0; k < layout.parts.size(); ++k) parts_.push_back(partOf(layout, k, samples));
  for (std::size_t p = 0; p < layout.pairs.size(); ++p) pairs_.push_back(pairOf(layout, p, samples));
  takeAll(samples, layout.pairs.size());
}

ClearanceChunk::Part ClearanceChunk::partOf(const StoreLayout& layout, std::size_t part,
                                            std::span<const PairSample> samples) const {
  const std::size_t frames = t_.size();
  std::vector<HalfBits> between, braking, error, uncertainty, closing;
  std::vector<std::uint16_t> link;
  std::vector<std::uint8_t> unknown;
  Part out;
  out.blocks.assign((frames + kBlock - 1) / kBlock, static_cast<float>(kInfinity));
  for (std::size_t i = 0; i < frames; ++i) {
    const std::span<const PairSample> frame = samples.subspan(i * layout.pairs.size(), layout.pairs.size());
    PairSample nearest;
    nearest.clearance = nearest.distance = kInfinity;
    std::uint16_t nearest_link = 0;
    double min_between = kInfinity, min_braking = kInfinity;
    bool lost = false;
    for (std::size_t p = 0; p < frame.size(); ++p) {
      if (layout.pairs[p].part != part) continue;
      const bool first = nearest.clearance == kInfinity;
      if (frame[p].clearance < nearest.clearance || first)
        nearest = frame[p], nearest_link = layout.pairs[p].link;
      min_between = std::min(min_between, frame[p].between);
      min_braking = std::min(min_braking, frame[p].braking);
      lost = lost || frame[p].lost;
    }
    const float clearance = floatBelow(nearest.clearance);
    out.clearance.push_back(clearance);
    between.push_back(halfBelow(min_between));
    braking.push_back(halfBelow(min_braking));
    error.push_back(halfAbove(nearest.distance - static_cast<double>(clearance)));
    uncertainty.push_back(halfAbove(nearest.uncertainty));
    closing.push_back(halfAbove(nearest.closing));
    link.push_back(nearest_link);
    unknown.push_back(lost || std::isinf(clearance));
    if (!unknown.back()) out.blocks[i / kBlock] = std::min(out.blocks[i / kBlock], clearance);
    out.all.least = std::min(out.all.least, static_cast<double>(clearance));
    out.all.largest = std::max(out.all.largest, static_cast<double>(clearance));
    out.all.between = std::min(out.all.between, fromHalf(between.back()));
    out.all.unknown = out.all.unknown || unknown.back() != 0;
  }
  out.clearance.shrink_to_fit();
  out.between = PackedColumn(between);
  out.braking = PackedColumn(braking);
  out.error = PackedColumn(error);
  out.uncertainty = PackedColumn(uncertainty);
  out.closing = PackedColumn(closing);
  out.link = PackedColumn(link);
  out.unknown = PackedColumn(unknown);
  return out;
}

ClearanceChunk::Pair ClearanceChunk::pairOf(const StoreLayout& layout, std::size_t pair,
                                            std::span<const PairSample> samples) const {
  Pair out;
  out.part = layout.pairs[pair].part;
  const std::vector<float>& nearest = parts_[out.part].clearance;
  std::vector<std::uint8_t> above;
  bool beside = false;
  for (std::size_t i = 0; i < t_.size(); ++i) {
    const double clearance = samples[i * layout.pairs.size() + pair].clearance;
    const double more = clearance - static_cast<double>(nearest[i]);
    // Where nothing is seen, no link is farther than another.
    above.push_back(std::isnan(more) ? 0 : static_cast<std::uint8_t>(std::min(more, kBeside) / kStep));
    beside = beside || more < kBeside || std::isnan(more);
    out.least = std::min(out.least, clearance);
  }
  if (beside) out.above = std::make_unique<PackedColumn<std::uint8_t>>(above);
  return out;
}

void ClearanceChunk::takeAll(std::span<const PairSample> samples, std::size_t pairs) {
  for (std::size_t i = 0; i < t_.size(); ++i) {
    double clearance = kInfinity, between = kInfinity, braking = kInfinity;
    for (const PairSample& sample : samples.subspan(i * pairs, pairs)) {
      clearance = std::min(clearance, sample.clearance);
      between = std::min(between, sample.between);
      braking = std::min(braking, sample.braking);
    }
    clearance_.push_back(floatBelow(clearance));
    between_.push_back(floatBelow(between));
    braking_.push_back(floatBelow(braking));
    least_ = std::min(least_, static_cast<double>(clearance_.back()));
    min_between_ = std::min(min_between_, static_cast<double>(between_.back()));
  }
}

ClearanceChunk::Nearest ClearanceChunk::nearest(std::size_t part, std::size_t frame) const {
  const Part& p = parts_[part];
  const double clearance = p.clearance[frame];
  return {clearance,
          clearance + fromHalf(p.error[frame]),
          fromHalf(p.uncertainty[frame]),
          fromHalf(p.between[frame]),
          fromHalf(p.braking[frame]),
          fromHalf(p.closing[frame]),
          p.link[frame],
          p.unknown[frame] != 0};
}

double ClearanceChunk::pairClearance(std::size_t pair, std::size_t frame) const {
  const Pair& p = pairs_[pair];
  const double nearest = parts_[p.part].clearance[frame];
  const double above = p.above ? kStep * (*p.above)[frame] : kBeside;
  return std::max(p.least, nearest + above);
}

std::size_t ClearanceChunk::bytes() const {
  std::size_t sum = sizeof(*this) + t_.capacity() * sizeof(double) + 3 * frames() * sizeof(float);
  for (const Part& p : parts_)
    sum += sizeof(p) + (p.clearance.capacity() + p.blocks.capacity()) * sizeof(float) + p.between.bytes() +
           p.braking.bytes() + p.error.bytes() + p.uncertainty.bytes() + p.closing.bytes() + p.link.bytes() +
           p.unknown.bytes();
  for (const Pair& p : pairs_) sum += sizeof(p) + (p.above ? sizeof(*p.above) + p.above->bytes() : 0);
  return sum;
}

ChunkWriter::ChunkWriter(std::shared_ptr<const StoreLayout> layout, double limit)
    : layout_(std::move(layout)), limit_(limit) {
  std::size_t kinds = 0;
  for (const StoreLayout::Body& part : layout_->parts) kinds = std::max(kinds, part.kind + 1);
  kind_judged_.assign(kinds, false);
}

std::shared_ptr<const ClearanceChunk> ChunkWriter::add(double t, std::span<const PairSample> samples) {
  judge(samples);
  if (!all_judged_) ++judged_;
  t_.push_back(t);
  samples_.insert(samples_.end(), samples.begin(), samples.end());
  return t_.size() == ClearanceChunk::kFrames ? finish() : nullptr;
}

/// Of several people, a part is judged from where the nearest one's can be, as in tune.
void ChunkWriter::judge(std::span<const PairSample> samples) {
  if (all_judged_) return;
  kind_braking_.assign(kind_judged_.size(), kInfinity);
  for (std::size_t p = 0; p < samples.size(); ++p) {
    double& braking = kind_braking_[layout_->parts[layout_->pairs[p].part].kind];
    braking = std::min(braking, samples[p].braking);
  }
  for (std::size_t k = 0; k < kind_judged_.size(); ++k)
    kind_judged_[k] = kind_judged_[k] || kind_braking_[k] > limit_;
  all_judged_ = std::all_of(kind_judged_.begin(), kind_judged_.end(), [](bool judged) { return judged; });
}

std::shared_ptr<const ClearanceChunk> ChunkWriter::finish() {
  if (t_.empty()) return nullptr;
  auto chunk = std::make_shared<const ClearanceChunk>(*layout_, std::move(t_), samples_, judged_);
  t_.clear();
  samples_.clear();
  judged_ = 0;
  return chunk;
}

}  // namespace abstand::margin
