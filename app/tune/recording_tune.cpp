#include "app/tune/recording_tune.hpp"

#include <algorithm>

#include "core/margin/safe_margin.hpp"

namespace abstand::tune {
namespace {

template <class T>
void dropFirst(std::vector<T>& list, std::size_t count) {
  list.erase(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(count));
}

/// s left out.
double dropUnjudged(PartClearance& part, const margin::MarginOptions& options) {
  const std::size_t first = margin::firstJudgedFrame(part.track, options);
  if (first == 0) return 0.0;
  const double begin = part.track.t.front(),
               left_out = first < part.track.frames() ? part.track.t[first] - begin : part.track.duration();
  part.track = margin::from(part.track, first);
  dropFirst(part.distance, first);
  dropFirst(part.bound, first);
  dropFirst(part.uncertainty, first);
  dropFirst(part.link, first);
  return left_out;
}

}  // namespace

TunedRecording tuneRecording(session::Session& session, const TuneOptions& options,
                             const run::RunOptions& run, const std::string& name) {
  margin::validate(options.margins());
  DistancePass pass(session, options.pass);
  run::RunOptions as_recorded = run;
  as_recorded.react = false;
  as_recorded.on_cycle = [&](double t, const std::vector<query::PairResult>& results) {
    pass.frame(t, results);
  };
  const run::RunSummary summary = run::runScene(session, as_recorded);
  TunedRecording tuned;
  tuned.recording = name;
  tuned.frames = summary.frames;
  tuned.interrupted = summary.interrupted;
  tuned.reservations = summary.reservations;
  tuned.pass = pass.finish();
  const margin::ClearanceTrack& any = tuned.pass.parts.front().track;
  if (any.frames() > 0) tuned.t0 = any.t.front(), tuned.t1 = any.t.back();
  for (PartClearance& part : tuned.pass.parts)
    tuned.unjudged = std::max(tuned.unjudged, dropUnjudged(part, options.margins()));
  return tuned;
}

}  // namespace abstand::tune
