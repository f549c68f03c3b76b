// abstand track live:kinect
#include "app/cli/live_track.hpp"

#include <iostream>

#include "app/cli/track_people.hpp"
#include "app/serve/skeleton_sender.hpp"
#include "core/base/error.hpp"
#include "core/base/write_error.hpp"
#include "core/scene/cycle_statistics.hpp"
#include "tracking/depth/live/live_depth.hpp"
#include "tracking/table/skeleton_csv.hpp"
#include "tracking/tracker/tracked_recording.hpp"

namespace abstand::cli {
namespace {

constexpr double kLook = 0.05;  // s between two checks of the end conditions

double since(std::chrono::steady_clock::time_point then) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count();
}

/// Results besides the track.
struct LiveOutcome {
  double seconds{0.0};                        ///< from the first image to the last
  scene::CycleStatistics latency{kInfinity};  ///< from the driver to the end of processing the image
  bool interrupted{false};
};

/// What images pass through.
struct LiveChain {
  LiveCameras& cameras;
  LiveThings& things;
  tracking::LiveTracker& tracker;
  serve::SkeletonSender* sender;  ///< or null
};

LiveOutcome follow(const CommandLine& line, const LiveChain& chain, const std::optional<double>& seconds) {
  const auto& [cameras, things, tracker, sender] = chain;
  LiveOutcome outcome;
  tracking::DepthMoment moment;
  while (!outcome.interrupted && !(seconds && outcome.seconds >= *seconds)) {
    outcome.interrupted = interrupted();
    if (sender && sender->outputError() != 0) break;
    const tracking::LiveDepth::Outcome next = cameras.moments().next(moment, kLook);
    for (const std::string& news : cameras.news(tracker.shares())) line.warn(news);
    if (next == tracking::LiveDepth::Outcome::kEnded || cameras.isOver(tracker.shares())) break;
    if (next == tracking::LiveDepth::Outcome::kNothingYet) continue;
    things.update(cameras.moments().came());
    for (const tracking::LiveTracker::Seen& seen : tracker.see(moment))
      if (sender) sender->send(seen.id, moment.t, seen.frame);
    for (const std::string& news : things.news(tracker.shown(), cameras.allNames())) line.warn(news);
    outcome.latency.add(since(cameras.moments().came()));
    outcome.seconds = moment.t;
  }
  return outcome;
}

/// All parts of the report on a tracked person.
struct LiveReport {
  const LiveCameras& cameras;
  const LiveThings& things;
  std::span<const tracking::ShownThings> shown;
  const tracking::ClipTrack& track;
  const tracking::ClipPerson& person;
  const LiveOutcome& outcome;
  const serve::SkeletonSender* sender;  ///< or null
  std::string ended;                    ///< why there are no more images; empty: there may be
  std::vector<std::string> warnings;
};

nlohmann::ordered_json camerasJson(const LiveReport& report) {
  nlohmann::ordered_json cameras = report.cameras.json(report.track);
  for (std::size_t c = 0; c < cameras.size(); ++c) cameras[c]["things"] = report.things.json(report.shown[c]);
  return cameras;
}

nlohmann::ordered_json liveDocument(const LiveReport& report) {
  const tracking::DepthFacts& facts = report.cameras.facts();
  const tracking::ClipTrack& track = report.track;
  const scene::CycleStatistics& latency = report.outcome.latency;
  const double seconds = report.outcome.seconds;
  const double rate = seconds > 0.0 ? static_cast<double>(track.images - 1) / seconds : 0.0;
  nlohmann::ordered_json document{
      {"format", facts.format},
      {"frames", track.images},
      {"tracked", report.person.found},
      {"lost", track.images - report.person.found},
      {"dropped", report.cameras.dropped()},
      {"fps", rate},
      {"latency_ms",
       {{"median", 1e3 * latency.median()}, {"p99", 1e3 * latency.p99()}, {"max", 1e3 * latency.max()}}},
      {"residual_mm", 1e3 * report.person.residual},
      {"people", peopleJson(track)},
      {"camera_reason", facts.camera_reason},
      {"world", track.world},
      {"cameras", camerasJson(report)},
      {"notes", facts.notes},
      {"ended", report.ended.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(report.ended)}};
  if (report.sender) {
    document["sent"] = report.sender->sent();
    document["unsent"] = report.sender->refused();
    document["nameless"] = report.sender->nameless();
  }
  std::vector<std::string> warnings = report.cameras.reported();
  for (const auto& more : {report.things.reported(), report.warnings})
    warnings.insert(warnings.end(), more.begin(), more.end());
  document["warnings"] = warnings;
  addStature(document, report.person.stature);
  addFacing(document, report.person.facing);
  return document;
}

std::string liveText(const LiveReport& report, std::size_t chosen) {
  const tracking::DepthFacts& facts = report.cameras.facts();
  const auto& [cameras, things, shown, track, person, outcome, sender, ended, warnings] = report;
  std::string text =
      format("%s: %zu images of %d x %d in %.1f s, %zu dropped\n", facts.format.c_str(), track.images,
             track.camera.width, track.camera.height, outcome.seconds, cameras.dropped());
  text += cameras.text(track) + "camera: " + facts.camera_reason + " (--camera)\nworld: " + track.world +
          "\n" + things.text(shown);
  text += format("people: %zu; number %d (--person) tracked in %zu images, %.1f mm from the body\n",
                 track.people.size(), static_cast<int>(chosen) + 1, person.found, 1e3 * person.residual);
  text += "height: " + tracking::statureReason(person.stature) + " (--height)\n";
  text += format("latency from driver image to skeleton: median %.1f ms, p99 %.1f, max %.1f\n",
                 1e3 * outcome.latency.median(), 1e3 * outcome.latency.p99(), 1e3 * outcome.latency.max());
  if (sender)
    text += format("sent: %ld skeletons, %ld refused by the system, %ld of unnamed people (--as)\n",
                   sender->sent(), sender->refused(), sender->nameless());
  text += tracking::facingReason(person.facing) + " (--facing)\n";
  for (const std::string& note : facts.notes) text += "note: " + note + "\n";
  for (const std::string& note : tracking::heldNotes(person)) text += "note: " + note + "\n";
  return text;
}

void printReport(const CommandLine& line, const LiveReport& report, const LiveTrackArguments& args) {
  for (const std::string& warning : report.warnings) line.warn(warning);
  const std::string text = liveText(report, args.chosen);
  if (args.send != "-")
    line.print(liveDocument(report), text);
  else if (!line.quiet)
    std::cerr << text;
}

/// The reader of standard output may have closed it; tracks are kept.
void checkOutput(const CommandLine& line, const serve::SkeletonSender& sender) {
  if (sender.isClosed()) line.warn("tracking ended: standard output was closed");
  if (sender.outputError() != 0 && !sender.isClosed() && sender.outputError() != EINTR)
    throw WriteError("standard output", sender.outputError());
}

}  // namespace

int runLiveTrack(const CommandLine& line, const LiveTrackArguments& args) {
  if (args.send == "-" && line.json)
    throw UsageError("--send -: found with --json, expected one of them on stdout");
  std::optional<serve::SkeletonSender> sender;
  if (!args.send.empty()) sender.emplace(args.send, args.names);
  LiveThings things(line, args.things);
  LiveCameras cameras(args.cameras);
  const tracking::DepthFacts& facts = cameras.facts();
  // With a guessed camera pose a skeleton would be at an arbitrary place relative to the robot.
  if (sender && !facts.pose_known)
    throw UsageError(
        "--send: found a camera without a pose, expected a camera file with T_WC "
        "(--camera; abstand calibrate makes one)");
  if (!args.things.scene.empty() && !facts.pose_known)
    throw UsageError(
        "--scene: found a camera without a pose, expected a camera file with T_WC "
        "(--camera; abstand calibrate makes one)");
  tracking::LiveTracker tracker(cameras.cameras(), facts.pose_known,
                                {.person = args.person,
                                 .keep = !args.out.empty(),
                                 .known = things.known(),
                                 .at_rest = things.atRest(),
                                 .watch = args.watch});
  if (!line.quiet) std::cerr << "track: looking through " << cameras.names() << std::endl;
  const LiveOutcome outcome =
      follow(line, {cameras, things, tracker, sender ? &*sender : nullptr}, args.seconds);
  const tracking::ClipTrack track = tracker.track();
  const std::string ended = cameras.ended(track.cameras);
  const ParseError end({cameras.size() == 1 ? cameras.name() : "live"}, ended);
  if (track.people.empty()) {
    if (outcome.interrupted) return endBeforeFound(line, track.images);
    if (!ended.empty()) throw end;
    throw ParseError({cameras.name()},
                     "found no person in " + std::to_string(track.images) + " images, expected a person");
  }
  if (args.chosen >= track.people.size())
    throw UsageError("--person: found " + std::to_string(track.people.size()) + " people, expected " +
                     std::to_string(args.chosen + 1) + " or more");
  const tracking::ClipPerson& person = track.people[args.chosen];
  if (!args.out.empty())
    tracking::writeSkeletonCsv(args.out, tracking::recordingOf(track, facts, args.chosen));

  const serve::SkeletonSender* const sent_by = sender ? &*sender : nullptr;
  printReport(line,
              {cameras, things, tracker.shown(), track, person, outcome, sent_by, ended,
               tracking::trackWarnings(person)},
              args);
  if (sender) checkOutput(line, *sender);
  if (ended.empty() && outcome.interrupted) return kInterrupted;
  if (ended.empty()) return cameras.reported().empty() ? kDone : kPartly;
  std::cerr << end.what() << std::endl;
  return kPartly;
}

}  // namespace abstand::cli
