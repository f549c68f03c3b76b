#include "app/tune/recording_tune.hpp"

#include <algorithm>
#include <set>

#include "app/session/input_content.hpp"
#include "app/tune/person_notes.hpp"
#include "app/tune/result_key.hpp"
#include "app/tune/stored_limits.hpp"
#include "app/tune/stored_terms.hpp"
#include "humanmodel/body_part.hpp"

namespace abstand::tune {
namespace {

/// Times of a pass, frame by frame.
class PassTimes {
 public:
  explicit PassTimes(double limit) : limit_{limit} {}

  /// Takes the last frame of the pass.
  void add(const PassResult& pass) {
    if (judged_.empty()) {
      judged_.resize(pass.parts.size(), false);
      t0 = pass.parts.front().track.t.back();
    }
    t1 = pass.parts.front().track.t.back();
    for (std::size_t p = 0; p < judged_.size(); ++p) {
      if (judged_[p]) continue;
      // As margin::firstJudgedFrame(): until a stop comes in time, or to the end.
      unjudged = std::max(unjudged, t1 - t0);
      judged_[p] = !(pass.parts[p].track.braking.back() <= limit_);
    }
  }

  double t0{0.0}, t1{0.0};  ///< s, first and last frame
  double unjudged{0.0};     ///< s, TunedRecording::unjudged

 private:
  double limit_;
  std::vector<bool> judged_;  ///< of each part
};

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

std::vector<InputFile> filesOf(const session::Session& session) {
  std::vector<InputFile> files;
  for (const std::filesystem::path& file : session::inputFiles(session.description())) {
    ContentHash hash;
    session::addContent(hash, file);
    // With its folder, and without the place of both on this machine.
    files.push_back({(file.parent_path().filename() / file.filename()).string(), hash.value().hex()});
  }
  return files;
}

/// These parts and those that the scene names for any of its people, sorted.
std::vector<std::string> clampedWith(const std::vector<std::string>& more, const session::Session& session) {
  std::set<std::string> parts(more.begin(), more.end());
  for (const auto& human : session.description().humans)
    for (const humanmodel::BodyPart part : human.clamped) parts.emplace(humanmodel::partName(part));
  return {parts.begin(), parts.end()};
}

}  // namespace

TunedRecording tuneRecording(session::Session& session, const TuneOptions& options,
                             const run::RunOptions& run, const std::string& name) {
  margin::validate(options.margins());
  PassOptions pass_options = options.pass;
  pass_options.clamped = clampedWith(options.pass.clamped, session);
  pass_options.frames = (run.rate ? session.frameTimes(*run.rate) : session.frameTimes()).size();
  PassTimes times(options.margins().limit);
  pass_options.on_frame = [&](const SettledFrame& settled, const PassResult& result) {
    times.add(result);
    if (options.pass.on_frame) options.pass.on_frame(settled, result);
  };
  DistancePass pass(session, pass_options);
  pauseOthers(pass.watched(), session);
  run::RunOptions as_recorded = run;
  as_recorded.react = false;
  as_recorded.extremes = false;
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
  tuned.warm_start = summary.warm_start;
  tuned.people = peopleOf(session);
  tuned.files = filesOf(session);
  if (const auto& standard = options.pass.separation_standard) {
    tuned.separation_edition = standard->edition;
    tuned.separation_table = standard->stamp();
    tuned.separation_terms = citedTerms(*standard);
  }
  if (options.pass.contact) tuned.contact_limits = options.pass.contact->stamp();
  tuned.pass = pass.finish();
  if (options.pass.contact) tuned.regions = occurringRegions(tuned.pass, *options.pass.contact);
  tuned.enclosed = enclosedIn(session, tuned.pass);
  tuned.t0 = times.t0;
  tuned.t1 = times.t1;
  tuned.unjudged = times.unjudged;
  return tuned;
}

}  // namespace abstand::tune
