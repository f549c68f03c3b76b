#include "app/tune/speed_table.hpp"

#include <algorithm>
#include <cmath>

#include "app/tune/part_frames.hpp"

namespace abstand::tune {

double permittedScale(SpeedRule rule, double by_separation, double by_contact) {
  if (rule == SpeedRule::kSeparation) return by_separation;
  return rule == SpeedRule::kContact ? by_contact : std::min(by_separation, by_contact);
}

std::vector<SpeedSegment> speedTable(const std::vector<TunedRecording>& recordings, double length,
                                     SpeedRule rule) {
  double begin = kInfinity, end = -kInfinity;
  for (const TunedRecording& r : recordings) begin = std::min(begin, r.t0), end = std::max(end, r.t1);
  std::vector<SpeedSegment> segments;
  if (!(end > begin)) return segments;
  const auto count = static_cast<std::size_t>(std::ceil((end - begin) / length - 1e-9));
  for (std::size_t i = 0; i < count; ++i)
    segments.push_back({begin + static_cast<double>(i) * length,
                        std::min(end, begin + static_cast<double>(i + 1) * length),
                        1.0,
                        {},
                        1.0,
                        1.0});
  for (std::size_t r = 0; r < recordings.size(); ++r) {
    PartByPart parts(recordings[r]);
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const PartClearance& part = parts.part(p);
      for (std::size_t i = 0; i < part.track.frames(); ++i) {
        const double t = part.track.t[i];
        const auto at = std::min(count - 1, static_cast<std::size_t>(std::max(0.0, (t - begin) / length)));
        SpeedSegment& s = segments[at];
        const double separation = part.separation.speed_scale[i], contact = part.contact_scale[i];
        s.by_separation = std::min(s.by_separation, separation);
        s.by_contact = std::min(s.by_contact, contact);
        const double scale = permittedScale(rule, separation, contact);
        if (scale >= s.speed_scale) continue;
        s.speed_scale = scale;
        const bool by_contact =
            rule == SpeedRule::kContact || (rule == SpeedRule::kBoth && contact < separation);
        s.limited_by = {
            r, t, part.part,
            by_contact && !part.contact_excluded ? SpeedLimit::kContact : SpeedLimit::kSeparation};
      }
    }
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
