// abstand track: tracks a person in a depth recording or a live camera.
#include <algorithm>

#include "app/cli/live_track.hpp"
#include "app/cli/track_cameras.hpp"
#include "app/cli/track_people.hpp"
#include "app/depth/scene_things.hpp"
#include "core/base/error.hpp"
#include "core/base/output_file.hpp"
#include "core/base/output_folder.hpp"
#include "tracking/depth/live/live_depth.hpp"
#include "tracking/table/skeleton_csv.hpp"
#include "tracking/tracker/track_picture.hpp"
#include "tracking/tracker/tracked_recording.hpp"

namespace abstand::cli {
namespace {

struct TrackArguments {
  std::vector<std::filesystem::path> depth, camera;
  std::filesystem::path out, pictures, scene;
  robot_file::PackagePaths packages;
  std::string height, rate, seconds, send, robots, facing{"auto"};
  std::vector<std::string> names, clock;
  int person{1};
  bool usual_body{false}, mirror{false};
  std::uint64_t seed{1};
};

double positive(const std::string& text, const std::string& option, double least, double most) {
  const double value = number(text, option);
  if (!(value >= least && value <= most))
    throw UsageError(option + ": found " + text + ", expected " + format("%g to %g", least, most));
  return value;
}

void draw(const tracking::ClipMoment& moment, OutputFolder& folder) {
  const std::string name = format("person%d_%06zu.png", moment.id, moment.image);
  tracking::saveColourPng(tracking::pictureOf(moment.frame.image, moment.camera, *moment.rig, moment.body),
                          folder.place(name));
}

double rateOf(const TrackArguments& args) {
  return args.rate.empty() ? 0.0 : positive(args.rate, "--rate", 1e-3, 1e6);
}

std::vector<LiveSource> liveSources(const TrackArguments& args) {
  const std::size_t count = args.depth.size();
  if (!args.camera.empty() && args.camera.size() != count)
    throw UsageError(format("--camera: found %zu files for %zu live cameras, expected one for each",
                            args.camera.size(), count));
  if (!args.clock.empty())
    throw UsageError("--clock: found with live cameras, which have the clock of this computer");
  std::vector<LiveSource> sources;
  for (std::size_t i = 0; i < count; ++i) {
    LiveSource& source = sources.emplace_back();
    source.name = args.depth[i].string();
    if (!tracking::isLiveSource(source.name))
      throw UsageError("found live cameras and recordings (" + source.name + "), expected one kind of them");
    if (!args.camera.empty()) source.stream.camera = args.camera[i];
    source.stream.rate = rateOf(args);
    source.stream.mirror = args.mirror;
  }
  return sources;
}

int live(const CommandLine& line, const TrackArguments& args, const tracking::ClipTrackerOptions& options) {
  if (args.scene.empty() && !args.robots.empty())
    throw UsageError("--robots: found without --scene, expected them together");
  if (args.send.empty() && !args.names.empty())
    throw UsageError("--as: found without --send, expected them together");
  LiveTrackArguments own;
  own.cameras = liveSources(args);
  own.things = {args.scene, args.packages, args.robots};
  if (args.robots.empty() && args.send != "-") own.things.server = args.send;
  own.person = options.person;
  own.person.fit_aside = true;
  own.watch = options.watch;
  if (!args.seconds.empty()) own.seconds = positive(args.seconds, "--seconds", 1e-3, 1e9);
  own.out = args.out;
  own.chosen = static_cast<std::size_t>(args.person - 1);
  own.send = args.send;
  own.names = args.names.empty() ? std::vector<std::string>{"operator"} : args.names;
  return runLiveTrack(line, own);
}

tracking::ClipTrackerOptions trackerOptions(const CommandLine& line, const TrackArguments& args) {
  tracking::ClipTrackerOptions options;
  if (!args.height.empty()) options.person.height = positive(args.height, "--height", 0.5, 2.5);
  options.person.fit_body = !args.usual_body;
  options.person.seed = args.seed;
  options.person.away = awayOf(args.facing);
  options.progress = progressBar(line, "images");
  options.interrupted = interrupted;
  return options;
}

/// One person of a tracked recording.
struct TrackedClip {
  const TrackCameras& cameras;
  const tracking::ClipTrack& track;
  const tracking::ClipPerson& person;
  const tracking::DepthFacts& facts;
  const tracking::Recording& recording;
  double fps() const {
    const double seconds = track.seconds + cameras.clockSeconds();
    return seconds > 0.0 ? static_cast<double>(track.images) / seconds : 0.0;
  }
};

nlohmann::ordered_json trackedDocument(const TrackedClip& clip) {
  const auto& [cameras, track, person, facts, recording] = clip;
  nlohmann::ordered_json document{{"format", facts.format},
                                  {"frames", track.images},
                                  {"tracked", person.found},
                                  {"lost", track.images - person.found},
                                  {"fps", clip.fps()},
                                  {"residual_mm", 1e3 * person.residual},
                                  {"people", peopleJson(track)},
                                  {"rate", facts.rate},
                                  {"rate_reason", facts.rate_reason},
                                  {"camera_reason", facts.camera_reason},
                                  {"world", track.world},
                                  {"cameras", cameras.json(track)},
                                  {"notes", recording.report.notes},
                                  {"warnings", recording.report.warnings},
                                  {"interrupted", track.interrupted}};
  addStature(document, person.stature);
  addFacing(document, person.facing);
  return document;
}

std::string trackedText(const TrackArguments& args, const TrackedClip& clip) {
  const auto& [cameras, track, person, facts, recording] = clip;
  std::string text = format("%s: %s, %zu images of %d x %d\n", args.depth.front().string().c_str(),
                            facts.format.c_str(), track.images, track.camera.width, track.camera.height);
  text += "time: " + facts.rate_reason + " (--rate)\ncamera: " + facts.camera_reason + " (--camera)\n";
  text += "world: " + track.world + "\n" + cameras.text(track);
  text += format("people: %zu, number %d selected (--person)\n", track.people.size(), args.person);
  text += format("tracked in %zu images, lost in %zu\n", person.found, track.images - person.found);
  text += "height: " + tracking::statureReason(person.stature) + " (--height)\n";
  text += format("mean distance to the body %.1f mm, %.0f images per second of processor time\n",
                 1e3 * person.residual, clip.fps());
  text += tracking::facingReason(person.facing) + " (--facing)\n";
  for (const std::string& note : facts.notes) text += "note: " + note + "\n";
  for (const std::string& note : tracking::heldNotes(person)) text += "note: " + note + "\n";
  return text;
}

/// Tracks, and writes the requested outputs.
int trackCameras(const CommandLine& line, const TrackArguments& args, const TrackCameras& cameras,
                 const tracking::ClipTrackerOptions& options, std::optional<OutputFolder>& pictures) {
  const tracking::ClipTrack track = tracking::trackClips(cameras.cameras(), options);
  // A person not found yet may be in the remaining images.
  const std::size_t chosen = static_cast<std::size_t>(args.person - 1);
  if (track.interrupted && chosen >= track.people.size()) return endBeforeFound(line, track.images);
  if (track.people.empty())
    throw ParseError({args.depth.front().string()}, "found no person in the depth recording, expected one");
  tracking::Recording recording = tracking::recordingOf(track, cameras.facts(), chosen);
  for (std::string& warning : cameras.warnings(track))
    recording.report.warnings.push_back(std::move(warning));
  std::optional<OutputFile> csv;
  if (!args.out.empty()) {
    tracking::writeSkeletonCsv(csv.emplace(args.out).stream(), recording);
    csv->finish();
  }
  if (pictures) pictures->commit();
  if (csv) csv->commit();

  const TrackedClip clip{cameras, track, track.people[chosen], cameras.facts(), recording};
  for (const std::string& warning : recording.report.warnings) line.warn(warning);
  line.print(trackedDocument(clip), trackedText(args, clip));
  return track.interrupted ? kInterrupted : kDone;
}

int trackRecording(const CommandLine& line, const TrackArguments& args, tracking::ClipTrackerOptions options,
                   std::optional<OutputFolder>& pictures) {
  if (!args.seconds.empty() || !args.send.empty() || !args.names.empty() || !args.robots.empty())
    throw UsageError("found --seconds, --send, --as or --robots with a recording, expected live:kinect");
  std::optional<depth::RobotView> robots;
  if (!args.scene.empty()) {
    session::SessionOptions session_options;
    session_options.cache = line.cache;
    session_options.monitor = buildMonitor(line);
    robots.emplace(scene_file::loadScene(args.scene, args.packages), session_options);
    options.known = [&](double t, const tracking::DepthCamera& camera) { return &robots->at(t, camera); };
  }
  TrackCameras cameras({args.depth, args.camera, args.clock, rateOf(args), args.mirror});
  if (robots && !cameras.facts().pose_known)
    throw UsageError(
        "--scene: found a recording without a camera pose, expected a camera file "
        "with T_WC (--camera)");
  cameras.compareClocks(options);
  if (robots)
    options.known = cameras.compareThings(
        {options.known,
         [&](double t, const tracking::DepthCamera& camera) { return robots->robotsAt(t, camera); },
         {}});
  return trackCameras(line, args, cameras, options, pictures);
}

int runTrack(const CommandLine& line, const TrackArguments& args) {
  tracking::ClipTrackerOptions options = trackerOptions(line, args);
  std::optional<OutputFolder> pictures;
  if (!args.pictures.empty()) {
    pictures.emplace(args.pictures);
    options.watch = [&](const tracking::ClipMoment& moment) { draw(moment, *pictures); };
  }
  const bool is_live = std::any_of(args.depth.begin(), args.depth.end(),
                                   [](const auto& depth) { return tracking::isLiveSource(depth.string()); });
  if (!is_live) return trackRecording(line, args, options, pictures);
  const int code = live(line, args, options);
  if (pictures) pictures->commit();
  return code;
}

}  // namespace

void addTrack(CLI::App& root, CommandLine& line) {
  auto* command = addCommand(root, line, "track", "tracks a person in a depth recording",
                             "abstand track clip --out person.csv");
  auto args = std::make_shared<TrackArguments>();
  command
      ->add_option("DEPTH", args->depth,
                   "folder or file of depth images (formats: docs/recordings.md); several, of cameras with "
                   "known poses in one world, are fitted together; or live cameras: "
                   "live:kinect, live:kinect:2 (the second), live:kinect:SERIAL")
      ->required()
      ->expected(1, static_cast<int>(tracking::BodyObservation::kMaxViews));
  command
      ->add_option("--camera", args->camera,
                   "camera file (.yaml); with several recordings or live cameras one for each, with commas")
      ->delimiter(',');
  command
      ->add_option("--clock", args->clock,
                   "s, added to the times of each recording after the first, with commas; auto: found by the "
                   "movements of people (default)")
      ->delimiter(',');
  command->add_option("--height", args->height, "m, of the person; default: measured in the first images");
  line.output(command->add_option("--out", args->out, "CSV of the joints (m, z up)"));
  line.output(
      command->add_option("--pictures", args->pictures, "folder for one PNG per image with the fitted body"),
      OutputKind::kFolder);
  command->add_option(
      "--scene", args->scene,
      "scene whose robots and objects are removed from the images; times and camera pose refer to the scene; "
      "with live:kinect, the robots are where --robots or --send has them");
  command->add_option(
      "--robots", args->robots,
      "HOST:PORT of the running `abstand serve` of --scene that knows where the robots are, with "
      "live:kinect; default: that of --send");
  addPackagePath(command, args->packages);
  addCacheFlag(command, line);
  command->add_option("--person", args->person, "number of the person; 1 is found in most images")
      ->check(CLI::Range(1, 64));
  command->add_option("--rate", args->rate, "Hz: image i is at t = i / rate");
  command->add_flag(
      "--usual-body", args->usual_body,
      "use mean lengths and girths for the stature, instead of fitting them to the first seconds");
  command->add_option("--facing", args->facing,
                      "initial facing: camera, away, or auto: the better fit to the first "
                      "seconds; with --usual-body auto is camera");
  command->add_flag("--mirror", args->mirror, "the images are mirrored");
  command->add_option("--seed", args->seed, "random seed of the limb search");
  command->add_option("--seconds", args->seconds, "duration in s with live:kinect; default: until Ctrl-C");
  command->add_option("--send", args->send,
                      "HOST:PORT of a running `abstand serve`, or - for standard output: skeletons of "
                      "live:kinect as lines of JSON; needs a camera file with T_WC");
  command
      ->add_option("--as", args->names,
                   "names in the scene of the people sent, in order of appearance (operator)")
      ->delimiter(',');
  command->callback([&line, args] { line.run = [&line, args] { return runTrack(line, *args); }; });
}

}  // namespace abstand::cli
