#include "app/cli/live_cameras.hpp"

#include <cmath>

#include "app/cli/track_people.hpp"
#include "core/base/error.hpp"
#include "tracking/tracker/doubtful_cameras.hpp"

namespace abstand::cli {
namespace {

std::vector<std::unique_ptr<tracking::LiveDepth>> opened(const std::vector<LiveSource>& sources) {
  for (std::size_t i = 0; i < sources.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (tracking::kinectOf(sources[i].name) == tracking::kinectOf(sources[k].name))
        throw UsageError("found " + sources[i].name + " twice, expected different cameras, such as " +
                         tracking::kKinectSource + ":2");
  std::vector<std::unique_ptr<tracking::LiveDepth>> cameras;
  for (const LiveSource& source : sources) {
    cameras.push_back(std::make_unique<tracking::LiveDepth>(source.name, source.stream));
    if (sources.size() > 1 && !cameras.back()->facts().pose_known)
      throw UsageError(source.name +
                       ": found a camera without a pose, expected T_WC in a camera file for each of several "
                       "(--camera; abstand calibrate makes one)");
  }
  return cameras;
}

}  // namespace

LiveCameras::LiveCameras(const std::vector<LiveSource>& sources)
    : moments_(opened(sources)),
      has_failed_(sources.size(), false),
      has_hung_(sources.size(), false),
      is_apart_(sources.size(), false),
      is_late_(sources.size(), false) {
  for (const LiveSource& source : sources) names_.push_back(source.name);
}

std::string LiveCameras::names() const {
  std::string text = names_.front();
  for (std::size_t c = 1; c < names_.size(); ++c)
    text += (c + 1 == names_.size() ? " and " : ", ") + names_[c];
  return text;
}

std::vector<tracking::DepthCamera> LiveCameras::cameras() const {
  std::vector<tracking::DepthCamera> cameras;
  for (std::size_t c = 0; c < size(); ++c) cameras.push_back(moments_.camera(c).camera());
  return cameras;
}

std::string LiveCameras::failureOf(std::size_t c, std::span<const tracking::CameraShare> shares) const {
  if (const std::string ended = moments_.ended(c); !ended.empty()) return ended;
  if (c >= shares.size() || !std::isfinite(shares[c].moved_at)) return {};
  return format("found the camera moved at %.2f s, expected it to stay in place; calibrate it again",
                shares[c].moved_at);
}

std::vector<std::string> LiveCameras::news(std::span<const tracking::CameraShare> shares) {
  std::vector<std::string> news;
  const auto sayOnce = [&](std::vector<bool>& said, std::size_t c, const std::string& text) {
    if (said[c]) return;
    said[c] = true;
    news.push_back(names_[c] + text);
  };
  const std::size_t known = std::min(size(), shares.size());
  for (std::size_t c = 0; c < known; ++c)
    if (std::isfinite(shares[c].hung_at))
      sayOnce(has_hung_, c,
              format(": found the same image repeated since %.2f s, expected new ones: it hangs, and is not "
                     "used until then",
                     shares[c].hung_at));
  for (std::size_t c = 0; c < known; ++c) {
    if (std::isfinite(shares[c].apart_since)) sayOnce(is_apart_, c, " " + tracking::apartReason(shares[c]));
    if (std::isfinite(shares[c].late_since)) sayOnce(is_late_, c, " " + tracking::lateReason(shares[c]));
  }
  for (std::size_t c = 0; size() > 1 && c < size(); ++c)
    if (const std::string failure = failureOf(c, shares); !failure.empty())
      sayOnce(has_failed_, c, ": " + failure);
  reported_.insert(reported_.end(), news.begin(), news.end());
  return news;
}

bool LiveCameras::isOver(std::span<const tracking::CameraShare> shares) const {
  for (std::size_t c = 0; c < size(); ++c)
    if (failureOf(c, shares).empty()) return false;
  return true;
}

std::string LiveCameras::ended(std::span<const tracking::CameraShare> shares) const {
  if (!isOver(shares)) return {};
  if (size() == 1) return failureOf(0, shares);
  std::string all;
  for (std::size_t c = 0; c < size(); ++c)
    all += (c > 0 ? "; " : "") + names_[c] + ": " + failureOf(c, shares);
  return all;
}

nlohmann::ordered_json LiveCameras::json(const tracking::ClipTrack& track) const {
  auto all = nlohmann::ordered_json::array();
  for (std::size_t c = 0; c < size(); ++c) {
    const tracking::LiveDepth& camera = moments_.camera(c);
    const tracking::CameraShare share = c < track.cameras.size() ? track.cameras[c] : tracking::CameraShare{};
    const std::string ended = moments_.ended(c);
    const auto orNull = [](bool known, auto value) {
      return known ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
    };
    nlohmann::ordered_json& one = all.emplace_back(cameraJson(names_[c], camera.facts(), share));
    one["dropped"] = camera.dropped();
    one["ended"] = orNull(!ended.empty(), ended);
  }
  return all;
}

std::string LiveCameras::text(const tracking::ClipTrack& track) const {
  if (size() == 1) return {};
  std::string text;
  for (std::size_t c = 0; c < std::min(size(), track.cameras.size()); ++c) {
    text += cameraText(c + 1, names_[c], track.cameras[c], track.images);
    text += format(", %zu dropped\n", moments_.camera(c).dropped());
  }
  text += format("maximum time difference of images fitted together: %.0f ms\n", 1e3 * track.lag);
  return text;
}

}  // namespace abstand::cli
