#include "app/tune/margin_events.hpp"

#include <algorithm>

namespace abstand::tune {
namespace {

MarginEvent eventOf(const TunedRecording& recording, const PartFrames& frames, std::size_t part,
                    double margin, const margin::Intrusion& in) {
  const PartClearance& p = frames.parts()[part];
  const auto first = p.track.clearance.begin() + static_cast<std::ptrdiff_t>(in.begin);
  const auto nearest = static_cast<std::size_t>(
      std::min_element(first, p.track.clearance.begin() + static_cast<std::ptrdiff_t>(in.end)) -
      p.track.clearance.begin());
  return {MarginEvent::Kind::kIntrusion,
          &recording,
          static_cast<std::uint16_t>(part),
          p.link[nearest],
          p.track.t[in.begin],
          p.track.t[std::min(in.end, p.track.frames() - 1)],
          p.track.t[nearest],
          in.min_clearance,
          in.braking,
          in.false_stop,
          in.missed,
          in.lead_time,
          static_cast<std::uint16_t>(part),
          p.link[in.begin],
          margin,
          p.track.clearance[in.begin],
          p.robot_speed[in.begin],
          p.person_speed[in.begin]};
}

void addBetweenFrames(const TunedRecording& recording, const PartFrames& frames, std::size_t part,
                      double margin, const margin::MarginOptions& options, std::vector<MarginEvent>& events) {
  const PartClearance& p = frames.parts()[part];
  for (std::size_t i = 0; i + 1 < p.track.frames(); ++i) {
    if (p.track.clearance[i] < margin || !(p.track.between[i] <= options.limit)) continue;
    events.push_back(betweenFramesEvent(recording, frames, part, i));
  }
}

}  // namespace

MarginEvent betweenFramesEvent(const TunedRecording& recording, const PartFrames& frames, std::size_t part,
                               std::size_t index) {
  const PartClearance& p = frames.parts()[part];
  MarginEvent event;
  event.kind = MarginEvent::Kind::kBetweenFrames;
  event.recording = &recording;
  event.part = event.told_part = static_cast<std::uint16_t>(part);
  event.link = event.told_link = p.link[index];
  event.t0 = event.t_nearest = p.track.t[index];
  event.t1 = p.track.t[std::min(index + 1, p.track.frames() - 1)];
  event.min_clearance = event.braking = p.track.between[index];
  event.missed = true;
  return event;
}

std::vector<MarginEvent> marginEvents(const TunedRecording& recording, double margin,
                                      const margin::MarginOptions& options, const std::string& part) {
  return marginEvents(recording, PartFrames(recording), margin, options, part);
}

std::vector<MarginEvent> marginEvents(const TunedRecording& recording, const PartFrames& frames,
                                      double margin, const margin::MarginOptions& options,
                                      const std::string& part) {
  std::vector<MarginEvent> events;
  for (std::size_t i = 0; i < frames.parts().size(); ++i) {
    const PartClearance& p = frames.parts()[i];
    if (!part.empty() && p.part != part) continue;
    for (const margin::Intrusion& in : margin::intrusions(p.track, margin, options))
      events.push_back(eventOf(recording, frames, i, margin, in));
    addBetweenFrames(recording, frames, i, margin, options, events);
  }
  std::stable_sort(events.begin(), events.end(),
                   [](const MarginEvent& a, const MarginEvent& b) { return a.t0 < b.t0; });
  return events;
}

}  // namespace abstand::tune
