#include "core/margin/inside_frames.hpp"

#include <algorithm>

namespace abstand::margin {

std::vector<PartMargins> partMargins(const StoreLayout& layout, std::span<const double> margins,
                                     double factor) {
  std::vector<PartMargins> of(layout.parts.size());
  for (std::size_t p = 0; p < layout.pairs.size(); ++p) {
    const auto [part, link] = layout.pairs[p];
    const double margin = factor * (margins[layout.parts[part].object] + margins[layout.links[link].object]);
    of[part].pairs.push_back({p, margin});
    of[part].least = std::min(of[part].least, margin);
    of[part].largest = std::max(of[part].largest, margin);
  }
  return of;
}

InsideFrames insideFrames(const ClearanceChunk& chunk, std::size_t part, const PartMargins& margins) {
  InsideFrames inside;
  const ClearanceChunk::Summary& all = chunk.summary(part);
  if (!(all.least < margins.largest)) return inside;
  inside.some = true;
  if (all.largest < margins.least) {
    inside.all = true;
    return inside;
  }
  for (std::size_t i = 0; i < chunk.frames(); ++i) {
    const double nearest = chunk.clearance(part, i);
    if (!(nearest < margins.largest)) continue;
    inside.frames[i] =
        nearest < margins.least ||
        (!margins.same() && std::any_of(margins.pairs.begin(), margins.pairs.end(), [&](const auto& pair) {
          return nearest < pair.margin && chunk.pairClearance(pair.pair, i) < pair.margin;
        }));
  }
  return inside;
}

}  // namespace abstand::margin
