// abstand calibrate CLIP --person: pose of a camera from a person who is known in the world.
#include "app/cli/calibrate_modes.hpp"
#include "app/cli/track_people.hpp"
#include "core/base/error.hpp"
#include "tracking/tracker/pose_from_person.hpp"
#include "tracking/tracker/tracked_recording.hpp"

namespace abstand::cli {
namespace {

// m; a person who stays at one place shows the camera's angles by his own size only.
constexpr double kLittleMoved = 0.5;

}  // namespace

int calibrateByPerson(const CommandLine& line, const CalibrateArguments& args) {
  if (tracking::isDepthRecording(args.person) && !tracking::openDepthStream(args.person)->facts().pose_known)
    throw UsageError(
        "--person: found a depth recording without a camera pose, expected one with "
        "T_WC, or a skeleton recording in world");
  tracking::DepthStreamOptions stream_options;
  stream_options.camera = args.camera;
  const auto stream = tracking::openDepthStream(args.input, stream_options);
  tracking::ClipTrackerOptions options;
  options.interrupted = interrupted;
  options.progress = progressBar(line, "images");
  const tracking::ClipTrack track = tracking::trackClip(*stream, options);
  if (track.interrupted) return endBeforeFound(line, track.images);
  if (track.people.empty())
    throw ParseError({args.input.string()}, "found no person in the depth recording, expected one");
  const tracking::Recording world = tracking::openAnyRecording(args.person, {}, std::nullopt);
  const tracking::PersonPoseFit fit =
      tracking::fitPoseToPerson(world.frames, track.people.front().frames, track.camera.X_WC);
  writePlaced(args, stream->camera(), fit.X_WC, fit.spread);
  std::vector<std::string> warnings;
  if (!fit.clock_known)
    warnings.push_back("the motion does not determine the clock offset: record faster motion");
  if (fit.moved < kLittleMoved)
    warnings.push_back(format("the person moved by only %.2f m: record a walking person", fit.moved));
  for (const std::string& warning : warnings) line.warn(warning);
  const nlohmann::ordered_json document{{"joints", fit.joints},
                                        {"used", fit.used},
                                        {"exchanged", fit.exchanged},
                                        {"clock", fit.clock},
                                        {"clock_known", fit.clock_known},
                                        {"T_WC", rowsOf(fit.X_WC)},
                                        {"rms", fit.rms},
                                        {"person_moved", fit.moved},
                                        {"spread", fit.spread},
                                        {"warnings", warnings}};
  line.print(document, format("%zu joints, %zu of them used, RMS error %.1f mm; clock offset %+.3f s\n",
                              fit.joints, fit.used, 1e3 * fit.rms, fit.clock) +
                           placedText(fit.X_WC, fit.spread));
  return kDone;
}

}  // namespace abstand::cli
