#include "app/tune/speed_table.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::tune {

std::vector<SpeedSegment> speedTable(const std::vector<TunedRecording>& recordings, double length) {
  double begin = kInfinity, end = -kInfinity;
  for (const TunedRecording& r : recordings) begin = std::min(begin, r.t0), end = std::max(end, r.t1);
  std::vector<SpeedSegment> segments;
  if (!(end > begin)) return segments;
  const auto count = static_cast<std::size_t>(std::ceil((end - begin) / length - 1e-9));
  for (std::size_t i = 0; i < count; ++i)
    segments.push_back({begin + static_cast<double>(i) * length,
                        std::min(end, begin + static_cast<double>(i + 1) * length),
                        1.0,
                        {}});
  for (std::size_t r = 0; r < recordings.size(); ++r)
    for (const PartClearance& part : recordings[r].pass.parts)
      for (std::size_t i = 0; i < part.track.frames(); ++i) {
        const double t = part.track.t[i];
        const auto at = std::min(count - 1, static_cast<std::size_t>(std::max(0.0, (t - begin) / length)));
        if (part.separation.speed_scale[i] >= segments[at].speed_scale) continue;
        segments[at].speed_scale = part.separation.speed_scale[i];
        segments[at].limited_by = {r, t, part.part};
      }
  return segments;
}

double cycleTime(const std::vector<SpeedSegment>& segments) {
  double time = 0.0;
  for (const SpeedSegment& s : segments)
    time += s.speed_scale > 0.0 ? (s.t1 - s.t0) / s.speed_scale : kInfinity;
  return time;
}

}  // namespace abstand::tune
