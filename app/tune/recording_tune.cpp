#include "app/tune/recording_tune.hpp"

#include <algorithm>
#include <set>

#include "app/session/input_content.hpp"
#include "app/tune/result_key.hpp"
#include "core/margin/safe_margin.hpp"
#include "humanmodel/body_part.hpp"

namespace abstand::tune {
namespace {

/// Time (s) at the beginning that cannot be judged.
double unjudged(const margin::ClearanceTrack& track, const margin::MarginOptions& options) {
  const std::size_t first = margin::firstJudgedFrame(track, options);
  if (first == 0) return 0.0;
  return first < track.frames() ? track.t[first] - track.t.front() : track.duration();
}

/// Content hash of all recordings that people follow.
std::string contentOf(const session::Session& session) {
  ContentHash hash;
  bool any = false;
  for (const auto& human : session.description().humans) {
    session::addContent(hash, human.recording.file);
    any = any || !human.recording.file.empty();
  }
  return any ? hash.value().hex() : std::string();
}

/// These parts and those that the scene names for any of its people, sorted.
std::vector<std::string> clampedWith(const std::vector<std::string>& more, const session::Session& session) {
  std::set<std::string> parts(more.begin(), more.end());
  for (const auto& human : session.description().humans)
    for (const humanmodel::BodyPart part : human.clamped) parts.emplace(humanmodel::partName(part));
  return {parts.begin(), parts.end()};
}

}  // namespace

std::size_t firstJudgedFrame(const TunedRecording& recording, const margin::MarginOptions& options) {
  std::size_t first = 0;
  for (const PartClearance& p : recording.pass.parts)
    first = std::max(first, margin::firstJudgedFrame(p.track, options));
  return first;
}

TunedRecording tuneRecording(session::Session& session, const TuneOptions& options,
                             const run::RunOptions& run, const std::string& name) {
  margin::validate(options.margins());
  PassOptions pass_options = options.pass;
  pass_options.clamped = clampedWith(options.pass.clamped, session);
  pass_options.frames = (run.rate ? session.frameTimes(*run.rate) : session.frameTimes()).size();
  DistancePass pass(session, pass_options);
  pauseOthers(pass.watched(), session);
  run::RunOptions as_recorded = run;
  as_recorded.react = false;
  as_recorded.on_cycle = [&](double t, const std::vector<query::PairResult>& results) {
    pass.frame(t, results);
  };
  const run::RunSummary summary = run::runScene(session, as_recorded);
  TunedRecording tuned;
  tuned.recording = name;
  tuned.content = contentOf(session);
  tuned.frames = summary.frames;
  tuned.interrupted = summary.interrupted;
  tuned.clamped = pass_options.clamped;
  tuned.reservations = summary.reservations;
  if (options.pass.contact) tuned.contact_limits = options.pass.contact->stamp();
  tuned.pass = pass.finish();
  const margin::ClearanceTrack& any = tuned.pass.parts.front().track;
  if (any.frames() > 0) tuned.t0 = any.t.front(), tuned.t1 = any.t.back();
  for (const PartClearance& part : tuned.pass.parts)
    tuned.unjudged = std::max(tuned.unjudged, unjudged(part.track, options.margins()));
  return tuned;
}

}  // namespace abstand::tune
