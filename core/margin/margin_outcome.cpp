#include "core/margin/margin_outcome.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "core/margin/pair_margins.hpp"

namespace abstand::margin {
namespace {

MarginFrame frameOf(const ClearanceTrack& track, std::size_t i, bool inside) {
  return {track.t[i], inside, track.clearance[i], track.between[i], track.braking[i]};
}

}  // namespace

void validate(const MarginOptions& options) {
  if (!std::isfinite(options.limit) || options.limit < 0.0)
    throw UsageError("found a limit that is negative or not finite, expected 0 m or more");
  if (!std::isfinite(options.restart_time) || options.restart_time < 0.0)
    throw UsageError("found a restart time that is negative or not finite, expected 0 s or more");
}

void MarginOutcome::add(const MarginOutcome& other) {
  stops += other.stops;
  false_stops += other.false_stops;
  missed_stops += other.missed_stops;
  unseen += other.unseen;
  stopped_time += other.stopped_time;
  time += other.time;
  min_clearance = std::min(min_clearance, other.min_clearance);
  if (other.lead_time && (!lead_time || *other.lead_time < *lead_time)) lead_time = other.lead_time;
}

std::vector<Intrusion> intrusions(const ClearanceTrack& track, double margin, const MarginOptions& options) {
  std::vector<Intrusion> all;
  OutcomeStream stream(options);
  std::size_t begin = 0, frame = 0;
  stream.on_stop = [&](const Stop& stop) {
    all.push_back(
        {begin, frame, stop.min_clearance, stop.braking, stop.false_stop, stop.missed, stop.lead_time});
  };
  bool was_inside = false;
  for (; frame < track.frames(); ++frame) {
    const bool inside = track.clearance[frame] < margin;
    if (inside && !was_inside) begin = frame;
    was_inside = inside;
    stream.add(frameOf(track, frame, inside));
  }
  stream.finish();
  return all;
}

MarginOutcome outcome(const ClearanceTrack& track, double margin, const MarginOptions& options) {
  OutcomeStream stream(options);
  for (std::size_t i = 0; i < track.frames(); ++i) stream.add(frameOf(track, i, track.clearance[i] < margin));
  return stream.finish();
}

std::vector<MarginOutcome> outcomes(const ClearanceTrack& track, std::span<const double> margins,
                                    const MarginOptions& options) {
  if (margins.empty()) return {};
  std::vector<std::vector<PairMargin>> sets;
  for (const double m : margins) sets.push_back({{m, 0.0, 0.0}});
  PairMarginSets judge(std::move(sets), options);
  const double no_speed = 0.0;
  for (std::size_t i = 0; i < track.frames(); ++i)
    judge.add({track.t[i],
               {&track.clearance[i], 1},
               {&no_speed, 1},
               {&no_speed, 1},
               track.between[i],
               track.braking[i]});
  return judge.finish();
}

}  // namespace abstand::margin
