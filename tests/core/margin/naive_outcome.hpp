// Margins judged straight from the definitions, with all frames at hand.
#pragma once

#include <algorithm>
#include <span>

#include "core/margin/outcome_stream.hpp"

namespace abstand::margin {

inline MarginOutcome naiveOutcome(std::span<const MarginFrame> frames, const MarginOptions& options) {
  MarginOutcome out;
  out.time = frames.back().t - frames.front().t;
  double stopped_until = -kInfinity;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (!frames[i].inside) {
      out.min_clearance = std::min({out.min_clearance, frames[i].clearance, frames[i].between});
      out.unseen += frames[i].between <= options.limit;
      continue;
    }
    const std::size_t begin = i;
    double least = kInfinity;
    std::optional<double> lead_time;
    for (; i < frames.size() && frames[i].inside; ++i) {
      const double here = std::min(frames[i].clearance, frames[i].between);
      if (here <= options.limit && !lead_time) lead_time = frames[i].t - frames[begin].t;
      least = std::min(least, here);
    }
    const double end = i < frames.size() ? frames[i].t : frames.back().t;
    const double until = std::min(frames.back().t, end + options.restart_time);
    out.stopped_time += std::max(0.0, until - std::max(frames[begin].t, stopped_until));
    stopped_until = std::max(stopped_until, until);
    ++out.stops;
    out.false_stops += least > options.limit;
    out.missed_stops += frames[begin].braking <= options.limit;
    out.min_clearance = std::min(out.min_clearance, frames[begin].braking);
    if (lead_time && (!out.lead_time || *lead_time < *out.lead_time)) out.lead_time = lead_time;
    --i;
  }
  out.missed_stops += out.unseen;
  return out;
}

inline MarginOutcome naiveOutcome(const ClearanceTrack& track, double margin, const MarginOptions& options) {
  std::vector<MarginFrame> frames;
  for (std::size_t i = 0; i < track.frames(); ++i)
    frames.push_back(
        {track.t[i], track.clearance[i] < margin, track.clearance[i], track.between[i], track.braking[i]});
  return naiveOutcome(frames, options);
}

}  // namespace abstand::margin
