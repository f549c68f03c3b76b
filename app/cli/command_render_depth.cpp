// abstand render-depth: depth images of a scene.
#include <chrono>

#include "app/cli/command_line.hpp"
#include "app/depth/clip_people.hpp"
#include "app/depth/depth_clip.hpp"
#include "app/depth/open_session.hpp"
#include "core/base/error.hpp"

namespace abstand::cli {
namespace {

struct RenderDepthArguments {
  std::filesystem::path scene, recording, camera, out;
  std::string eye, look, noise{"kinect"}, rate{"30"}, start, end;
  std::string format{"png"}, body{"model"}, girth, clothing, height;
  std::uint64_t seed{1}, body_seed{0};
  int width{640};
  bool room{false};
  robot_file::PackagePaths packages;
};

tracking::DepthCamera cameraOf(const RenderDepthArguments& args, session::Session& session) {
  tracking::DepthCamera camera;
  if (!args.camera.empty()) {
    if (args.width != 640) throw UsageError("--width: found together with --camera, expected one of them");
    camera = tracking::loadDepthCamera(args.camera);
  } else {
    const double part = args.width / 640.0;
    camera.width = args.width;
    camera.height = args.width * 3 / 4;
    camera.fx = camera.fy = 580.0 * part;
    camera.cx = 0.5 * (camera.width - 1);
    camera.cy = 0.5 * (camera.height - 1);
  }
  if (!args.eye.empty())
    camera.X_WC = tracking::lookingAt(point(args.eye, "--eye"), point(args.look, "--look"));
  else if (args.camera.empty())
    camera.X_WC = depth::usualView(session);
  return camera;
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
  if (args.eye.empty() != args.look.empty())
    throw UsageError("found one of --eye and --look, expected both or none");
  depth::DepthClipOptions options;
  options.rate = number(args.rate, "--rate");
  if (!(options.rate > 0.0 && options.rate <= 1000.0))
    throw UsageError("--rate: found " + args.rate + ", expected above 0, at most 1000 frames per second");
  if (!args.start.empty()) options.start = number(args.start, "--start");
  if (!args.end.empty()) options.end = number(args.end, "--end");
  options.seed = args.seed;
  if (args.format == "freenect") options.format = depth::ClipFormat::kFreenect;
  options.skin = skinOf(args);
  options.room = args.room;
  options.progress = progressBar(line, "frames");
  options.interrupted = interrupted;

  session::SessionOptions session_options;
  if (!args.scene.empty()) session_options.recording = args.recording;
  session_options.cache = line.cache;
  session_options.monitor = buildMonitor(line);
  const auto opened = depth::openSession(sceneOf(args), session_options);
  session::Session& session = *opened;
  options.camera = cameraOf(args, session);
  if (args.noise == "kinect") options.noise = tracking::kinectNoiseIn(options.camera);

  const auto begin = std::chrono::steady_clock::now();
  const depth::DepthClipSummary summary = depth::writeDepthClip(session, options, args.out);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const nlohmann::ordered_json document{
      {"frames", summary.frames},        {"width", options.camera.width},
      {"height", options.camera.height}, {"noise", args.noise},
      {"measured", summary.measured},    {"fps", static_cast<double>(summary.frames) / seconds},
      {"out", args.out.string()},        {"remarks", session.remarks()}};
  line.print(document, format("%zu frames of %d x %d in %s, %.1f %% of the pixels measured\n", summary.frames,
                              options.camera.width, options.camera.height, args.out.string().c_str(),
                              100.0 * summary.measured));
  return summary.interrupted ? kInterrupted : kDone;
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
  command->add_option("--camera", args->camera,
                      "camera file; default: a Kinect in front of the first person");
  command->add_option("--eye", args->eye, "X,Y,Z, m: where the camera is, with --look");
  command->add_option("--look", args->look, "X,Y,Z, m: what it looks at");
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
