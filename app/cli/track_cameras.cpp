#include "app/cli/track_cameras.hpp"

#include <algorithm>
#include <cmath>

#include "app/cli/things_report.hpp"
#include "app/cli/track_people.hpp"
#include "core/base/error.hpp"
#include "tracking/tracker/compared_clocks.hpp"

namespace abstand::cli {
namespace {

// Share of the moments without an image of a camera from which on it is reported.
constexpr double kManyWithout = 0.1;
constexpr double kFarthestClock = 1e6;  // s

std::string metresApart(const tracking::ClockOffset& offset) {
  return format("RMS joint deviation %.0f mm over %.1f s", 1e3 * offset.apart, offset.overlap);
}

}  // namespace

TrackCameras::TrackCameras(const Arguments& arguments) {
  const std::size_t count = arguments.depth.size();
  if (!arguments.camera.empty() && arguments.camera.size() != count)
    throw UsageError(format("--camera: found %zu files for %zu recordings, expected one for each",
                            arguments.camera.size(), count));
  const bool is_given = !arguments.clock.empty() && arguments.clock != std::vector<std::string>{"auto"};
  if (is_given && arguments.clock.size() + 1 != count)
    throw UsageError(
        format("--clock: found %zu numbers for %zu recordings, expected one for each after the first",
               arguments.clock.size(), count));
  names_ = arguments.depth;
  clock_reasons_.assign(count, "that of the track");
  clock_known_.assign(count, true);
  for (std::size_t i = 0; i < count; ++i) {
    tracking::DepthStreamOptions options;
    if (!arguments.camera.empty()) options.camera = arguments.camera[i];
    options.rate = arguments.rate;
    options.mirror = arguments.mirror;
    streams_.push_back(tracking::openDepthStream(arguments.depth[i], options));
    if (count > 1 && !streams_.back()->facts().pose_known)
      throw UsageError(names_[i].string() +
                       ": found a recording without a camera pose, expected T_WC in a camera "
                       "file for each of several (--camera)");
    double offset = 0.0;
    if (i > 0) {
      clock_known_[i] = is_given;
      clock_reasons_[i] = "as given";
      if (is_given) offset = number(arguments.clock[i - 1], "--clock");
      if (!(std::abs(offset) <= kFarthestClock))
        throw UsageError("--clock: found " + arguments.clock[i - 1] + ", expected seconds");
    }
    cameras_.push_back({streams_.back().get(), offset});
  }
}

void TrackCameras::compareClocks(const tracking::ClipTrackerOptions& options) {
  if (std::find(clock_known_.begin(), clock_known_.end(), false) == clock_known_.end()) return;
  std::vector<tracking::DepthStream*> streams;
  for (const auto& stream : streams_) streams.push_back(stream.get());
  const tracking::ComparedClocks clocks = tracking::compareClocks(streams, options);
  clock_seconds_ = clocks.seconds;
  for (std::size_t i = 1; i < cameras_.size(); ++i) {
    const tracking::ClockOffset& found = clocks.offsets[i - 1];
    clock_known_[i] = found.decided;
    if (found.decided) cameras_[i].offset = found.offset;
    clock_reasons_[i] =
        found.overlap > 0.0
            ? (found.decided ? "from the motion: " : "not determined by the motion: ") + metresApart(found)
            : "the recordings have no motion in common";
  }
}

tracking::KnownThings TrackCameras::compareThings(const tracking::KnownObjects& objects) {
  double band = 0.0;
  for (const tracking::ClipCamera& camera : cameras_) {
    const auto atClock = [&camera](const tracking::KnownThings& things) -> tracking::KnownThings {
      return [&](double t, const tracking::DepthCamera& view) { return things(t + camera.offset, view); };
    };
    things_.push_back(
        tracking::compareWithKnown(*camera.stream, {atClock(objects.known), atClock(objects.robots), {}}));
    if (things_.back().show()) band = std::max(band, things_.back().displaced.band());
  }
  return tracking::withBand(objects.known, band);
}

nlohmann::ordered_json TrackCameras::json(const tracking::ClipTrack& track) const {
  auto all = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < cameras_.size(); ++i) {
    nlohmann::ordered_json& camera =
        all.emplace_back(cameraJson(names_[i].string(), streams_[i]->facts(), track.cameras.at(i)));
    camera["clock_offset"] = cameras_[i].offset;
    camera["clock_known"] = static_cast<bool>(clock_known_[i]);
    camera["clock_reason"] = clock_reasons_[i];
    camera["things"] = things_.empty() ? nlohmann::ordered_json()
                                       : thingsJson(true, things_[i].pixels.share(), things_[i].displaced);
  }
  return all;
}

std::string TrackCameras::text(const tracking::ClipTrack& track) const {
  if (cameras_.size() == 1) return {};
  std::string text;
  for (std::size_t i = 0; i < cameras_.size(); ++i) {
    text += cameraText(i + 1, names_[i].string(), track.cameras.at(i), track.images) + "\n";
    text += format("camera %zu: clock %+.3f s, %s (--clock)\n", i + 1, cameras_[i].offset,
                   clock_reasons_[i].c_str());
  }
  text += format("maximum time difference of images fitted together: %.0f ms\n", 1e3 * track.lag);
  return text;
}

std::vector<std::string> TrackCameras::warnings(const tracking::ClipTrack& track) const {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < things_.size(); ++i) {
    const tracking::ObjectsInImages& things = things_[i];
    const std::string name = format("scene: camera %zu shows the robots and objects ", i + 1);
    if (const std::string reason = tracking::bandReason(things.displaced); things.show() && !reason.empty())
      out.push_back(name + reason);
    if (!things.show() && std::isfinite(things.pixels.share()))
      out.push_back(name + format("in %.0f %% of their pixels: they are not where the scene has them, or the "
                                  "camera is not (T_WC), and people behind these places are not seen",
                                  100.0 * things.pixels.share()));
  }
  for (std::size_t i = 0; i < cameras_.size(); ++i) {
    const tracking::CameraShare& share = track.cameras.at(i);
    if (!clock_known_[i])
      out.push_back(format("camera %zu: its clock is assumed equal to that of the first, %s (--clock)", i + 1,
                           clock_reasons_[i].c_str()));
    const bool is_left_out =
        std::isfinite(share.apart_since) || std::isfinite(share.moved_at) || std::isfinite(share.hung_at);
    if (static_cast<double>(share.without) > kManyWithout * static_cast<double>(track.images))
      out.push_back(format("camera %zu: %s at %zu of %zu times: parts visible to it alone are hidden then",
                           i + 1, is_left_out ? "no image, or none that is used," : "no image", share.without,
                           track.images));
    if (share.images > 0 && share.people == 0)
      out.push_back(format("camera %zu: found no person in %zu images", i + 1, share.images));
  }
  return out;
}

}  // namespace abstand::cli
