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

LiveOutcome follow(tracking::LiveDepth& camera, tracking::LiveTracker& tracker, serve::SkeletonSender* sender,
                   const std::optional<double>& seconds) {
  LiveOutcome outcome;
  tracking::LiveFrame live;
  while (!outcome.interrupted && !(seconds && outcome.seconds >= *seconds)) {
    outcome.interrupted = interrupted();
    if (sender && sender->outputError() != 0) break;
    const tracking::LiveDepth::Outcome next = camera.next(live, kLook);
    if (next == tracking::LiveDepth::Outcome::kEnded) break;
    if (next == tracking::LiveDepth::Outcome::kNothingYet) continue;
    for (const tracking::LiveTracker::Seen& seen : tracker.see(live.frame))
      if (sender) sender->send(seen.id, live.frame.t, seen.body->frame);
    outcome.latency.add(since(live.came));
    outcome.seconds = live.frame.t;
  }
  return outcome;
}

/// All parts of the report on a tracked person.
struct LiveReport {
  const tracking::LiveDepth& camera;
  const tracking::ClipTrack& track;
  const tracking::ClipPerson& person;
  const LiveOutcome& outcome;
  const serve::SkeletonSender* sender;  ///< or null
  std::string ended;                    ///< why the stream ended; empty: it has not
  std::vector<std::string> warnings;
};

nlohmann::ordered_json liveDocument(const LiveReport& report) {
  const tracking::DepthFacts& facts = report.camera.facts();
  const tracking::ClipTrack& track = report.track;
  const scene::CycleStatistics& latency = report.outcome.latency;
  const double seconds = report.outcome.seconds;
  const double rate = seconds > 0.0 ? static_cast<double>(track.images - 1) / seconds : 0.0;
  nlohmann::ordered_json document{
      {"format", facts.format},
      {"frames", track.images},
      {"tracked", report.person.found},
      {"lost", track.images - report.person.found},
      {"dropped", report.camera.dropped()},
      {"fps", rate},
      {"latency_ms",
       {{"median", 1e3 * latency.median()}, {"p99", 1e3 * latency.p99()}, {"max", 1e3 * latency.max()}}},
      {"residual_mm", 1e3 * report.person.residual},
      {"people", peopleJson(track)},
      {"camera_reason", facts.camera_reason},
      {"world", track.world},
      {"notes", facts.notes},
      {"ended", report.ended.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(report.ended)}};
  if (report.sender) {
    document["sent"] = report.sender->sent();
    document["unsent"] = report.sender->refused();
    document["nameless"] = report.sender->nameless();
  }
  document["warnings"] = report.warnings;
  addStature(document, report.person.stature);
  addFacing(document, report.person.facing);
  return document;
}

std::string liveText(const LiveReport& report, std::size_t chosen) {
  const tracking::DepthFacts& facts = report.camera.facts();
  const auto& [camera, track, person, outcome, sender, ended, warnings] = report;
  std::string text =
      format("%s: %zu images of %d x %d in %.1f s, %zu dropped\n", facts.format.c_str(), track.images,
             track.camera.width, track.camera.height, outcome.seconds, camera.dropped());
  text += "camera: " + facts.camera_reason + " (--camera)\nworld: " + track.world + "\n";
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
  tracking::LiveDepth camera(args.camera, args.stream);
  const tracking::DepthFacts& facts = camera.facts();
  // With a guessed camera pose a skeleton would be at an arbitrary place relative to the robot.
  if (sender && !facts.pose_known)
    throw UsageError(
        "--send: found a camera without a pose, expected a camera file with T_WC "
        "(--camera; abstand calibrate makes one)");
  tracking::LiveTracker tracker(camera.camera(), facts.pose_known,
                                {.person = args.person, .keep = !args.out.empty(), .watch = args.watch});
  if (!line.quiet) std::cerr << "track: looking through " << args.camera << std::endl;
  const LiveOutcome outcome = follow(camera, tracker, sender ? &*sender : nullptr, args.seconds);
  const tracking::ClipTrack track = tracker.track();
  const std::string ended = camera.ended();
  const ParseError end({args.camera}, ended);
  if (track.people.empty()) {
    if (outcome.interrupted) return endBeforeFound(line, track.images);
    if (!ended.empty()) throw end;
    throw ParseError({args.camera},
                     "found no person in " + std::to_string(track.images) + " images, expected a person");
  }
  if (args.chosen >= track.people.size())
    throw UsageError("--person: found " + std::to_string(track.people.size()) + " people, expected " +
                     std::to_string(args.chosen + 1) + " or more");
  const tracking::ClipPerson& person = track.people[args.chosen];
  if (!args.out.empty())
    tracking::writeSkeletonCsv(args.out, tracking::recordingOf(track, facts, args.chosen));

  const serve::SkeletonSender* const sent_by = sender ? &*sender : nullptr;
  printReport(line, {camera, track, person, outcome, sent_by, ended, tracking::trackWarnings(person)}, args);
  if (sender) checkOutput(line, *sender);
  if (ended.empty()) return outcome.interrupted ? kInterrupted : kDone;
  std::cerr << end.what() << std::endl;
  return kPartly;
}

}  // namespace abstand::cli
