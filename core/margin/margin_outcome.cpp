#include "core/margin/margin_outcome.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "core/margin/outcome_stream.hpp"

namespace abstand::margin {
namespace {

/// First frame after `begin` that is outside, or the number of frames.
std::size_t endOf(const ClearanceTrack& track, std::size_t begin, double margin) {
  std::size_t i = begin;
  while (i < track.frames() && track.clearance[i] < margin) ++i;
  return i;
}

Intrusion intrusionAt(const ClearanceTrack& track, std::size_t begin, std::size_t end,
                      const MarginOptions& options) {
  Intrusion in;
  in.begin = begin;
  in.end = end;
  in.min_clearance = kInfinity;
  for (std::size_t i = begin; i < end; ++i) {
    const double least = std::min(track.clearance[i], track.between[i]);
    if (least <= options.limit && !in.lead_time) in.lead_time = track.t[i] - track.t[begin];
    in.min_clearance = std::min(in.min_clearance, least);
  }
  in.braking = track.braking[begin];
  in.false_stop = in.min_clearance > options.limit;
  in.missed = in.braking <= options.limit;
  return in;
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
  for (std::size_t i = 0; i < track.frames(); ++i) {
    if (!(track.clearance[i] < margin)) continue;
    const std::size_t end = endOf(track, i, margin);
    all.push_back(intrusionAt(track, i, end, options));
    i = end;
  }
  return all;
}

MarginOutcome outcome(const ClearanceTrack& track, double margin, const MarginOptions& options) {
  OutcomeStream stream(options);
  for (std::size_t i = 0; i < track.frames(); ++i)
    stream.add(
        {track.t[i], track.clearance[i] < margin, track.clearance[i], track.between[i], track.braking[i]});
  return stream.finish();
}

}  // namespace abstand::margin
