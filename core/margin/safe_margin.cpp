#include "core/margin/safe_margin.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::margin {

void SafeMarginWatch::add(double clearance, double between, double braking) {
  judged_ = judged_ || braking > options_.limit;
  if (judged_) {
    // A clearance that does not decrease commands no stop at this frame.
    if (braking <= options_.limit && before_ > clearance)
      need(before_, std::isinf(before_) ? 0.0 : before_ - clearance);
    // Events before the next frame are prevented only by a stop commanded at this frame or earlier.
    if (between <= options_.limit) need(clearance, std::max(0.0, clearance - between));
    before_ = clearance;
  }
  ++frames_;
}

void SafeMarginWatch::need(double margin, double sampling) {
  if (safe_.decided && !(margin > safe_.margin)) return;
  safe_ = {std::max(margin, 0.0), frames_, true, sampling};
}

SafeMargin smallestSafeMargin(const ClearanceTrack& track, const MarginOptions& options) {
  SafeMarginWatch watch(options, true);
  for (std::size_t b = 0; b < track.frames(); ++b)
    watch.add(track.clearance[b], track.between[b], track.braking[b]);
  return watch.value();
}

std::size_t firstJudgedFrame(const ClearanceTrack& track, const MarginOptions& options) {
  std::size_t first = 0;
  while (first < track.frames() && track.braking[first] <= options.limit) ++first;
  return first;
}

double roundedUpMargin(double needed) {
  constexpr double kMillimetre = 1e-3;
  return std::isinf(needed) ? needed : (std::floor(needed / kMillimetre) + 1.0) * kMillimetre;
}

ClearanceTrack from(const ClearanceTrack& track, std::size_t first) {
  const auto tail = [&](const std::vector<double>& v) {
    return std::vector<double>(v.begin() + static_cast<std::ptrdiff_t>(first), v.end());
  };
  return {tail(track.t), tail(track.clearance), tail(track.between), tail(track.braking)};
}

}  // namespace abstand::margin
