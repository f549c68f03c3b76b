// abstand render-depth: depth images of a scene.
#include <algorithm>
#include <chrono>
#include <deque>

#include "app/cli/command_line.hpp"
#include "app/depth/clip_people.hpp"
#include "app/depth/depth_clip.hpp"
#include "app/depth/open_session.hpp"
#include "core/base/error.hpp"
#include "core/base/output_folder.hpp"
#include "tracking/tracker/body_observation.hpp"

namespace abstand::cli {
namespace {

struct RenderDepthArguments {
  std::filesystem::path scene, recording, out;
  std::vector<std::filesystem::path> camera;
  std::vector<std::string> eye, look;
  std::string noise{"kinect"}, rate{"30"}, start, end;
  std::string format{"png"}, body{"model"}, girth, clothing, height;
  std::uint64_t seed{1}, body_seed{0};
  int width{640};
  bool room{false};
  robot_file::PackagePaths packages;
};

tracking::DepthCamera kinectCamera(int width) {
  tracking::DepthCamera camera;
  const double part = width / 640.0;
  camera.width = width;
  camera.height = width * 3 / 4;
  camera.fx = camera.fy = 580.0 * part;
  camera.cx = 0.5 * (camera.width - 1);
  camera.cy = 0.5 * (camera.height - 1);
  return camera;
}

/// One for each --camera or --eye, otherwise the usual one.
std::vector<tracking::DepthCamera> camerasOf(const RenderDepthArguments& args, session::Session& session) {
  const std::size_t files = args.camera.size(), eyes = args.eye.size();
  if (files > 0 && args.width != 640)
    throw UsageError("--width: found together with --camera, expected one of them");
  if (args.look.size() != eyes && !(args.look.size() == 1 && eyes > 0))
    throw UsageError(format("found %zu of --eye and %zu of --look, expected as many of both, or one --look",
                            eyes, args.look.size()));
  if (files > 1 && eyes == 1)
    throw UsageError(
        format("found %zu of --camera and one --eye, which would put all cameras in one place, "
               "expected as many of both",
               files));
  if (files > 1 && eyes > 1 && files != eyes)
    throw UsageError(format("found %zu of --camera and %zu of --eye, expected as many of both", files, eyes));
  const std::size_t count = std::max({files, eyes, std::size_t{1}});
  if (count > tracking::BodyObservation::kMaxViews)
    throw UsageError(format("found %zu cameras, expected at most %zu", count,
                            std::size_t{tracking::BodyObservation::kMaxViews}));
  std::vector<tracking::DepthCamera> cameras;
  for (std::size_t c = 0; c < count; ++c) {
    tracking::DepthCamera& camera = cameras.emplace_back(
        files > 0 ? tracking::loadDepthCamera(args.camera[files > 1 ? c : 0]) : kinectCamera(args.width));
    if (eyes > 0)
      camera.X_WC = tracking::lookingAt(point(args.eye[eyes > 1 ? c : 0], "--eye"),
                                        point(args.look[args.look.size() > 1 ? c : 0], "--look"));
    else if (files == 0)
      camera.X_WC = depth::usualView(session);
  }
  return cameras;
}

std::optional<tracking::SkinOptions> skinOf(const RenderDepthArguments& args) {
  if (args.body == "skin") {
    tracking::SkinOptions skin;
    if (!args.girth.empty()) skin.girth = number(args.girth, "--girth");
    if (!args.clothing.empty()) skin.clothing = number(args.clothing, "--clothing");
    skin.seed = args.body_seed;
    return skin;
  }
  if (!args.girth.empty() || !args.clothing.empty() || args.body_seed != 0)
    throw UsageError("found --girth, --clothing or --body-seed without --body skin, expected them with it");
  return std::nullopt;
}

scene_file::SceneDescription sceneOf(const RenderDepthArguments& args) {
  if (!args.scene.empty()) {
    if (!args.height.empty())
      throw UsageError("--height: found with a scene, which states the statures; expected one of them");
    return scene_file::loadScene(args.scene, args.packages);
  }
  if (args.recording.empty()) throw UsageError("found neither SCENE nor --recording, expected one or both");
  std::optional<double> height;
  if (!args.height.empty()) height = number(args.height, "--height");
  return abstand::depth::sceneOf(args.recording, height);
}

int runRenderDepth(const CommandLine& line, const RenderDepthArguments& args) {
  depth::DepthClipOptions options;
  options.rate = number(args.rate, "--rate");
  if (!(options.rate > 0.0 && options.rate <= 1000.0))
    throw UsageError("--rate: found " + args.rate + ", expected above 0, at most 1000 frames per second");
  if (!args.start.empty()) options.start = number(args.start, "--start");
  if (!args.end.empty()) options.end = number(args.end, "--end");
  options.seed = args.seed;
  if (args.format == "freenect") options.format = depth::ClipFormat::kFreenect;
  options.skin = skinOf(args);
  options.progress = progressBar(line, "frames");
  options.interrupted = interrupted;

  session::SessionOptions session_options;
  if (!args.scene.empty()) session_options.recording = args.recording;
  session_options.cache = line.cache;
  session_options.monitor = buildMonitor(line);
  const auto opened = depth::openSession(sceneOf(args), session_options);
  session::Session& session = *opened;
  const std::vector<tracking::DepthCamera> cameras = camerasOf(args, session);
  if (args.room) options.room = cameras;
  std::deque<OutputFolder> folders;
  auto written = nlohmann::ordered_json::array();
  std::string text;
  depth::DepthClipSummary first, last;
  const auto begin = std::chrono::steady_clock::now();
  std::size_t frames = 0;
  for (std::size_t c = 0; c < cameras.size() && !last.interrupted; ++c) {
    const std::filesystem::path out =
        cameras.size() == 1 ? args.out : args.out / ("camera_" + std::to_string(c + 1));
    options.camera = cameras[c];
    options.seed = args.seed + c;
    if (args.noise == "kinect") options.noise = tracking::kinectNoiseIn(options.camera);
    last = depth::writeDepthClip(session, options, folders.emplace_back(out));
    if (c == 0) first = last;
    frames += last.frames;
    written.push_back({{"out", out.string()},
                       {"frames", last.frames},
                       {"width", options.camera.width},
                       {"height", options.camera.height},
                       {"measured", last.measured}});
    text += format("%zu frames of %d x %d in %s, %.1f %% of the pixels measured\n", last.frames,
                   options.camera.width, options.camera.height, out.string().c_str(), 100.0 * last.measured);
  }
  for (OutputFolder& folder : folders) folder.commit();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const nlohmann::ordered_json document{
      {"frames", first.frames},           {"width", cameras.front().width},
      {"height", cameras.front().height}, {"noise", args.noise},
      {"measured", first.measured},       {"fps", static_cast<double>(frames) / seconds},
      {"out", args.out.string()},         {"cameras", written},
      {"remarks", session.remarks()}};
  line.print(document, text);
  return last.interrupted ? kInterrupted : kDone;
}

}  // namespace

void addRenderDepth(CLI::App& root, CommandLine& line) {
  auto* command =
      addCommand(root, line, "render-depth", "renders a scene as seen by a depth camera, as a clip",
                 "abstand render-depth data/scenes/hug_boxing.yaml --out clip --end 2");
  auto args = std::make_shared<RenderDepthArguments>();
  command->add_option("SCENE", args->scene,
                      "scene file (.yaml); without one: the person of --recording alone");
  line.output(command->add_option("--out", args->out, "folder of the clip"), OutputKind::kFolder)->required();
  command
      ->add_option("--format", args->format,
                   "png: PNG and depth.txt; freenect: a libfreenect record, also for fakenect")
      ->check(CLI::IsMember({"png", "freenect"}));
  command->add_option("--recording", args->recording,
                      "recording that moves every person, instead of the scene's");
  command
      ->add_option("--camera", args->camera,
                   "camera file; default: a Kinect in front of the first person; several with commas, whose "
                   "clips are folders in --out")
      ->delimiter(',');
  // A point has commas, too: one value for each option.
  command->add_option("--eye", args->eye, "X,Y,Z, m: where the camera is, with --look; once for each camera")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command
      ->add_option("--look", args->look, "X,Y,Z, m: what it looks at; once for each camera, or once for all")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->add_option("--width", args->width, "pixels, without --camera")->check(CLI::IsMember({320, 640}));
  command->add_option("--rate", args->rate, "frames per second (30)");
  command->add_option("--start", args->start, "s");
  command->add_option("--end", args->end, "s");
  command->add_option("--noise", args->noise, "noise model; kinect: a Kinect v1; none: an ideal camera")
      ->check(CLI::IsMember({"kinect", "none"}));
  command->add_option("--seed", args->seed, "of the noise");
  command
      ->add_option("--body", args->body,
                   "body shape; model: as in the scene; skin: a smooth surface that differs from the model")
      ->check(CLI::IsMember({"model", "skin"}));
  command->add_option("--girth", args->girth, "factor on the girths of a skin body (1)");
  command->add_option("--clothing", args->clothing, "thickness of clothing in m on a skin body (0)");
  command->add_option(
      "--body-seed", args->body_seed,
      "random seed of individual girths of a skin body, within 8 % of the mean (0: mean girths)");
  command->add_option("--height", args->height, "m, without SCENE: the recording is scaled to that stature");
  command->add_flag("--room", args->room, "adds a floor at z = 0 and a wall 1.5 m behind the people");
  addPackagePath(command, args->packages);
  addCacheFlag(command, line);
  command->callback([&line, args] { line.run = [&line, args] { return runRenderDepth(line, *args); }; });
}

}  // namespace abstand::cli
