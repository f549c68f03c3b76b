// abstand calibrate: where a depth camera stands, from matched points.
#include "app/cli/command_line.hpp"
#include "core/base/output_file.hpp"
#include "core/base/text_file.hpp"
#include "tracking/depth/depth_camera.hpp"
#include "tracking/depth/pose_from_points.hpp"

namespace abstand::cli {
namespace {

struct Arguments {
  std::filesystem::path points, camera, out;
};

int run(const CommandLine& line, const Arguments& args) {
  DepthCamera camera = loadDepthCamera(args.camera);
  const std::vector<MatchedPoint> points = readMatchedPoints(readFile(args.points), args.points.string());
  const PoseFit fit = fitPose(points);
  camera.X_WC = fit.X_WC;
  camera.spread = fit.spread;
  if (!args.out.empty()) writeFile(args.out, describeDepthCamera(camera));

  const Eigen::Matrix<double, 3, 4, Eigen::RowMajor> T = fit.X_WC.matrix().topRows<3>();
  const nlohmann::ordered_json document{{"points", points.size()},
                                        {"T_WC", std::vector<double>(T.data(), T.data() + T.size())},
                                        {"rms", fit.rms},
                                        {"worst", fit.worst},
                                        {"worst_line", fit.worst_point + 2},
                                        {"spread", fit.spread}};
  const Vector3d p = fit.X_WC.translation();
  line.print(
      document,
      format(
          "%zu points: %.2f mm off on the mean square, line %zu worst with %.2f mm\n"
          "camera at %.4f, %.4f, %.4f m; a point of it is known to %.2f mm (standard deviation of an axis)\n",
          points.size(), 1e3 * fit.rms, fit.worst_point + 2, 1e3 * fit.worst, p.x(), p.y(), p.z(),
          1e3 * fit.spread));
  return kDone;
}

}  // namespace

void addCalibrate(CLI::App& root, CommandLine& line) {
  auto* command = addCommand(root, line, "calibrate", "where a depth camera stands, from matched points",
                             "abstand calibrate points.csv --camera kinect.yaml --out placed.yaml");
  auto args = std::make_shared<Arguments>();
  command->add_option("POINTS", args->points, "CSV: cx,cy,cz,wx,wy,wz, m; in the camera's axes and in world")
      ->required();
  command->add_option("--camera", args->camera, "camera file with the intrinsics")->required();
  command->add_option("--out", args->out, "the same with the pose T_WC and its spread");
  command->callback([&line, args] { line.run = [&line, args] { return run(line, *args); }; });
}

}  // namespace abstand::cli
