// abstand calibrate: pose of a depth camera.
#include "app/cli/calibrate_modes.hpp"
#include "core/base/error.hpp"
#include "core/base/output_file.hpp"

namespace abstand::cli {
namespace {

int runCalibrate(const CommandLine& line, const CalibrateArguments& args) {
  if (args.links.empty() && !args.robot.empty())
    throw UsageError("--robot: found without --links, expected a depth recording there");
  if (!args.room.empty() && (!args.images.empty() || !args.links.empty() || !args.person.empty()))
    throw UsageError("--room: found together with --chessboard, --links or --person, expected one of them");
  if (!args.images.empty()) {
    if (!args.links.empty())
      throw UsageError("--chessboard: found together with --links, expected one of them");
    if (!args.input.empty())
      throw UsageError("--chessboard: found together with " + args.input.string() + ", expected one of them");
    return calibrateByBoard(line, args);
  }
  if (!args.squares.empty() || !args.square.empty() || !args.boards.empty() || args.intrinsics)
    throw UsageError("found --squares, --square, --board or --intrinsics without --chessboard, expected it");
  if (args.input.empty())
    throw UsageError(
        "found neither a table of points, nor --chessboard, nor SCENE with --links, nor CLIP with --person "
        "or "
        "--room, expected one of them");
  if (!args.person.empty() && !args.links.empty())
    throw UsageError("--person: found together with --links, expected one of them");
  if (!args.person.empty()) return calibrateByPerson(line, args);
  if (!args.room.empty()) return calibrateByRoom(line, args);
  if (!args.links.empty()) return calibrateByLinks(line, args);
  if (args.camera.empty()) throw UsageError("--camera: found none, expected a camera file");
  return calibrateByPoints(line, args);
}

}  // namespace

void writePlaced(const CalibrateArguments& args, const tracking::DepthCamera& recorded, const Transform& X_WC,
                 double spread) {
  if (args.out.empty()) return;
  tracking::DepthCamera camera = args.camera.empty() ? recorded : tracking::loadDepthCamera(args.camera);
  camera.X_WC = X_WC;
  camera.spread = spread;
  writeFile(args.out, tracking::describeDepthCamera(camera));
}

std::string placedText(const Transform& X_WC, double spread) {
  const Vector3d p = X_WC.translation();
  return format(
      "camera at %.4f, %.4f, %.4f m; position uncertainty %.2f mm (standard deviation along the worst "
      "axis)\n",
      p.x(), p.y(), p.z(), 1e3 * spread);
}

std::vector<double> rowsOf(const Transform& X_WC) {
  const Eigen::Matrix<double, 3, 4, Eigen::RowMajor> T = X_WC.matrix().topRows<3>();
  return {T.data(), T.data() + T.size()};
}

void addCalibrate(CLI::App& root, CommandLine& line) {
  auto* command = addCommand(
      root, line, "calibrate",
      "estimates the pose of a depth camera from matched points, a chessboard, a robot's links, a "
      "person or the room",
      "abstand calibrate points.csv --camera kinect.yaml --out placed.yaml\n"
      "  abstand calibrate --chessboard board.png --squares 8x5 --square 0.03 --board 0.4,-0.2,0.75 "
      "--camera kinect.yaml --out placed.yaml\n  "
      "abstand calibrate data/scenes/hug_boxing.yaml --links clip --robot left_arm --camera rough.yaml "
      "--out placed.yaml\n  "
      "abstand calibrate side_clip --person front_clip --out placed.yaml\n  "
      "abstand calibrate side_clip --room front_clip --camera rough.yaml --out placed.yaml");
  auto args = std::make_shared<CalibrateArguments>();
  command->add_option("POINTS", args->input,
                      "CSV: cx,cy,cz,wx,wy,wz, m; in the camera's axes and in world; with --links a scene "
                      "file; with --person or --room a "
                      "depth recording of the camera");
  command->add_option("--camera", args->camera, "camera file with the intrinsics");
  line.output(
      command->add_option("--out", args->out, "camera file to write, with the pose T_WC and its spread"));
  command->add_option("--chessboard", args->images, "PNG images of a board, infrared or colour");
  command->add_option("--squares", args->squares, "of the board, along x and y: 8x5");
  command->add_option("--square", args->square, "m, side of a square");
  command
      ->add_option(
          "--board", args->boards,
          "X,Y,Z or X,Y,Z,ROLL,PITCH,YAW (m, rad): the board's frame in world, once or once per image; its "
          "origin is the inner corner at the dark corner square, x along the first side of --squares, z "
          "towards the viewer")
      ->allow_extra_args(false);
  command->add_flag(
      "--intrinsics", args->intrinsics,
      "estimates the intrinsics from 5 or more images of the board in different poses, of which the first "
      "are those of --board");
  command->add_option(
      "--links", args->links,
      "depth recording of a robot of SCENE, at the scene's times; the start is the camera file's T_WC, "
      "within 0.1 m and 10 degrees of the true pose");
  command->add_option("--person", args->person,
                      "recording of the same person in world: depth images of a camera with T_WC, or "
                      "skeletons; clocks may differ "
                      "by 5 s");
  command->add_option(
      "--room", args->room,
      "depth recording of the same room by a camera with T_WC; the start is the T_WC of --camera or of CLIP, "
      "within 0.2 m and 20 degrees of the true pose");
  command->add_option("--robot", args->robot,
                      "mechanism of SCENE whose links are visible (default: the only one)");
  command->add_option("--seed", args->seed, "random seed of the search with --links");
  addPackagePath(command, args->packages);
  addCacheFlag(command, line);
  command->callback([&line, args] { line.run = [&line, args] { return runCalibrate(line, *args); }; });
}

}  // namespace abstand::cli
