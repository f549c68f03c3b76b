// abstand calibrate: pose of a depth camera from matched points.
#include "app/cli/calibrate_modes.hpp"
#include "core/base/output_file.hpp"
#include "core/base/text_file.hpp"
#include "tracking/depth/calibration/pose_from_points.hpp"

namespace abstand::cli {

int calibrateByPoints(const CommandLine& line, const CalibrateArguments& args) {
  tracking::DepthCamera camera = tracking::loadDepthCamera(args.camera);
  const std::vector<tracking::MatchedPoint> points =
      tracking::readMatchedPoints(readFile(args.input), args.input.string());
  const tracking::PoseFit fit = tracking::fitPose(points);
  camera.X_WC = fit.X_WC;
  camera.spread = fit.spread;
  if (!args.out.empty()) writeFile(args.out, tracking::describeDepthCamera(camera));

  const nlohmann::ordered_json document{
      {"points", points.size()}, {"T_WC", rowsOf(fit.X_WC)},          {"rms", fit.rms},
      {"worst", fit.worst},      {"worst_line", fit.worst_point + 2}, {"spread", fit.spread}};
  line.print(document, format("%zu points: RMS error %.2f mm, maximum in line %zu with %.2f mm\n",
                              points.size(), 1e3 * fit.rms, fit.worst_point + 2, 1e3 * fit.worst) +
                           placedText(fit.X_WC, fit.spread));
  return kDone;
}

}  // namespace abstand::cli
