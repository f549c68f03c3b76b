#include "core/margin/safe_margin.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::margin {

SafeMargin smallestSafeMargin(const ClearanceTrack& track, const MarginOptions& options) {
  SafeMargin safe;
  const auto needs = [&](double margin, std::size_t frame, double sampling) {
    if (safe.decided && !(margin > safe.margin)) return;
    safe.margin = std::max(margin, 0.0);
    safe.frame = frame;
    safe.decided = true;
    safe.sampling = sampling;
  };
  for (std::size_t b = 0; b < track.frames(); ++b) {
    const double before = b > 0 ? track.clearance[b - 1] : kInfinity;
    // A clearance that does not fall tells no stop at this frame.
    if (track.braking[b] <= options.limit && before > track.clearance[b])
      needs(before, b, b > 0 ? before - track.clearance[b] : 0.0);
    // What happens before the next frame is prevented only by a stop that was told at this one or earlier.
    if (track.between[b] <= options.limit)
      needs(track.clearance[b], b, std::max(0.0, track.clearance[b] - track.between[b]));
  }
  return safe;
}

std::size_t firstJudgedFrame(const ClearanceTrack& track, const MarginOptions& options) {
  std::size_t first = 0;
  while (first < track.frames() && track.braking[first] <= options.limit) ++first;
  return first;
}

ClearanceTrack from(const ClearanceTrack& track, std::size_t first) {
  const auto tail = [&](const std::vector<double>& v) {
    return std::vector<double>(v.begin() + static_cast<std::ptrdiff_t>(first), v.end());
  };
  return {tail(track.t), tail(track.clearance), tail(track.between), tail(track.braking)};
}

}  // namespace abstand::margin
