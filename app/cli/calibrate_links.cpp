// abstand calibrate SCENE --links: pose of a camera from depth images of a robot.
#include "app/cli/calibrate_modes.hpp"
#include "app/depth/calibration_links.hpp"
#include "core/base/error.hpp"
#include "tracking/depth/calibration/surface_pose.hpp"
#include "tracking/depth/formats/depth_stream.hpp"

namespace abstand::cli {
namespace {

constexpr std::size_t kMaxImages = 8;

/// Evenly spaced frames of the recording.
std::vector<tracking::DepthFrame> imagesOf(tracking::DepthStream& stream) {
  std::vector<tracking::DepthFrame> frames;
  const std::size_t count = std::min(kMaxImages, stream.size());
  for (std::size_t i = 0; i < count; ++i) {
    stream.seek(count > 1 ? i * (stream.size() - 1) / (count - 1) : 0);
    tracking::DepthFrame frame;
    if (stream.next(frame)) frames.push_back(std::move(frame));
  }
  return frames;
}

}  // namespace

int calibrateByLinks(const CommandLine& line, const CalibrateArguments& args) {
  tracking::DepthStreamOptions stream_options;
  stream_options.camera = args.camera;
  const auto stream = tracking::openDepthStream(args.links, stream_options);
  if (!stream->facts().pose_known)
    throw UsageError(
        "--links: found a recording without a camera pose, expected a camera file with a "
        "rough "
        "T_WC (--camera)");
  session::SessionOptions session_options;
  session_options.cache = line.cache;
  session_options.monitor = buildMonitor(line);
  depth::CalibrationLinks links(scene_file::loadScene(args.input, args.packages), args.robot,
                                session_options);
  std::vector<tracking::SurfaceView> views;
  for (tracking::DepthFrame& frame : imagesOf(*stream))
    views.push_back({std::move(frame.image), links.at(frame.t)});
  if (views.empty()) throw ParseError({args.links.string()}, "found no image, expected one or more");
  const tracking::SurfaceFit fit =
      tracking::fitPoseToSurfaces(stream->camera(), links.surfaces(), views, args.seed);
  writePlaced(args, stream->camera(), fit.X_WC, fit.spread);
  const nlohmann::ordered_json document{{"robot", links.robot()},
                                        {"links", links.surfaces().size()},
                                        {"images", views.size()},
                                        {"points", fit.points},
                                        {"explained", fit.explained},
                                        {"T_WC", rowsOf(fit.X_WC)},
                                        {"rms", fit.rms},
                                        {"moved", fit.moved},
                                        {"turned", fit.turned},
                                        {"spread", fit.spread}};
  line.print(
      document,
      format("%s: %zu points on %zu links in %zu images, RMS error %.2f mm; %.0f %% of the robot surface "
             "that should "
             "be visible "
             "was found\n"
             "moved by %.1f mm and turned by %.2f degrees from the start\n",
             links.robot().c_str(), fit.points, links.surfaces().size(), views.size(), 1e3 * fit.rms,
             100.0 * fit.explained, 1e3 * fit.moved, fit.turned / unit::deg(1.0)) +
          placedText(fit.X_WC, fit.spread));
  return kDone;
}

}  // namespace abstand::cli
