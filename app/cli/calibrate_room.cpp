// abstand calibrate CLIP --room: pose of a camera from the room that another camera sees, too.
#include "app/cli/calibrate_modes.hpp"
#include "app/cli/json_values.hpp"
#include "core/base/error.hpp"
#include "tracking/depth/calibration/room_pose.hpp"
#include "tracking/depth/calibration/room_warnings.hpp"
#include "tracking/depth/calibration/still_image.hpp"

namespace abstand::cli {
namespace {

tracking::RoomView viewOf(tracking::DepthStream& stream, const std::filesystem::path& file) {
  if (stream.size() == 0) throw ParseError({file.string()}, "found no image, expected one or more");
  return {stream.camera(), tracking::stillImage(stream)};
}

}  // namespace

int calibrateByRoom(const CommandLine& line, const CalibrateArguments& args) {
  const auto known = tracking::openDepthStream(args.room);
  if (!known->facts().pose_known)
    throw UsageError("--room: found a depth recording without a camera pose, expected one with T_WC");
  tracking::DepthStreamOptions stream_options;
  stream_options.camera = args.camera;
  const auto stream = tracking::openDepthStream(args.input, stream_options);
  if (!stream->facts().pose_known)
    throw UsageError(
        "--room: found a recording to calibrate without a camera pose, expected a camera file with a rough "
        "T_WC "
        "(--camera)");
  const tracking::RoomFit fit =
      tracking::fitPoseToRoom(viewOf(*known, args.room), viewOf(*stream, args.input));
  writePlaced(args, stream->camera(), fit.X_WC, fit.spread);
  const std::vector<std::string> warnings = tracking::warningsOf(fit);
  for (const std::string& warning : warnings) line.warn(warning);
  const nlohmann::ordered_json document{{"points", fit.points},
                                        {"shared", fit.agreement.shared},
                                        {"agreeing", fit.agreement.agreeing},
                                        {"seen_through", fit.agreement.seen_through},
                                        {"T_WC", rowsOf(fit.X_WC)},
                                        {"rms", fit.rms},
                                        {"moved", fit.moved},
                                        {"turned", fit.turned},
                                        {"rival", numberOrNull(fit.rival)},
                                        {"spread", fit.spread},
                                        {"warnings", warnings}};
  line.print(
      document,
      format("%zu points, RMS error %.2f mm; the other camera sees %.0f %% of the surfaces of this one, and "
             "both "
             "agree on %.0f %% of their common view\n"
             "moved by %.1f mm and turned by %.2f degrees from the start\n",
             fit.points, 1e3 * fit.rms, 100.0 * fit.agreement.shared, 100.0 * fit.agreement.agreeing,
             1e3 * fit.moved, fit.turned / unit::deg(1.0)) +
          placedText(fit.X_WC, fit.spread));
  return kDone;
}

}  // namespace abstand::cli
