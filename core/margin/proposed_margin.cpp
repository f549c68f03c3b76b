#include "core/margin/proposed_margin.hpp"

#include <algorithm>
#include <map>

namespace abstand::margin {
namespace {

/// The part of `parts` that is nearest in a frame; the first of equal ones.
std::size_t nearestPart(const ClearanceChunk& chunk, const std::vector<std::size_t>& parts,
                        std::size_t frame) {
  return *std::min_element(parts.begin(), parts.end(), [&](std::size_t a, std::size_t b) {
    return chunk.clearance(a, frame) < chunk.clearance(b, frame);
  });
}

PartProposal propose(const ClearanceStore& store, std::vector<std::size_t> parts,
                     const MarginOptions& options) {
  PartProposal proposal;
  SafeMarginWatch watch(options);
  std::size_t first = 0, frame = 0;
  for (const auto& chunk : store.chunks())
    for (std::size_t i = 0; i < chunk->frames(); ++i, ++frame) {
      double clearance = kInfinity, between = kInfinity, braking = kInfinity;
      for (const std::size_t part : parts) {
        clearance = std::min(clearance, chunk->clearance(part, i));
        between = std::min(between, chunk->between(part, i));
        braking = std::min(braking, chunk->braking(part, i));
      }
      watch.add(clearance, between, braking);
      if (!watch.judged()) first = frame + 1;
    }
  const SafeMargin& safe = watch.value();
  proposal.parts = std::move(parts);
  proposal.judged = watch.judged();
  if (!safe.decided) return proposal;
  proposal.margin = roundedUpMargin(safe.margin);
  const std::size_t told = safe.frame, before = told > first ? told - 1 : told;
  const auto chunkOf = [&](std::size_t f) -> const ClearanceChunk& {
    return *store.chunks()[f / ClearanceChunk::kFrames];
  };
  const std::size_t in_told = told % ClearanceChunk::kFrames, in_before = before % ClearanceChunk::kFrames;
  const std::size_t part = nearestPart(chunkOf(told), proposal.parts, in_told);
  const auto then =
      chunkOf(before).nearest(nearestPart(chunkOf(before), proposal.parts, in_before), in_before);
  proposal.decided_by = {store.t(told),
                         part,
                         chunkOf(told).nearest(part, in_told).link,
                         std::max(0.0, then.distance - then.clearance - then.uncertainty),
                         then.uncertainty,
                         safe.sampling};
  return proposal;
}

}  // namespace

std::vector<PartProposal> proposeMargins(const ClearanceStore& store, const MarginOptions& options) {
  std::vector<std::size_t> kinds;
  std::map<std::size_t, std::vector<std::size_t>> parts_of;
  for (std::size_t part = 0; part < store.layout().parts.size(); ++part) {
    const std::size_t kind = store.layout().parts[part].kind;
    if (parts_of[kind].empty()) kinds.push_back(kind);
    parts_of[kind].push_back(part);
  }
  std::vector<PartProposal> proposals;
  for (const std::size_t kind : kinds) proposals.push_back(propose(store, parts_of[kind], options));
  return proposals;
}

}  // namespace abstand::margin
