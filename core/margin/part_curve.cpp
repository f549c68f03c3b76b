#include "core/margin/part_curve.hpp"

#include <algorithm>

#include "core/margin/outcome_stream.hpp"

namespace abstand::margin {

MarginOutcome partOutcome(const ClearanceStore& store, std::size_t part, const PartMargins& margins,
                          const MarginOptions& options) {
  OutcomeStream stream(options);
  bool judged = false;
  for (const auto& chunk : store.chunks()) {
    const InsideFrames inside = insideFrames(*chunk, part, margins);
    const ClearanceChunk::Summary& all = chunk->summary(part);
    if (judged && !inside.some && !stream.stopping() && all.between > options.limit) {
      stream.addOutside(
          {chunk->t(0), chunk->t(chunk->frames() - 1), std::min(all.least, all.between), kInfinity, {}, 0});
      continue;
    }
    for (std::size_t i = 0; i < chunk->frames(); ++i) {
      const double braking = chunk->braking(part, i);
      judged = judged || braking > options.limit;
      if (judged)
        stream.add({chunk->t(i), inside.at(i), chunk->clearance(part, i), chunk->between(part, i), braking});
    }
  }
  return judged ? stream.finish() : MarginOutcome{};
}

}  // namespace abstand::margin
