// Live cameras of `abstand track`.
#pragma once

#include <nlohmann/json.hpp>

#include "tracking/tracker/clip_tracker.hpp"
#include "tracking/tracker/live_moments.hpp"

namespace abstand::cli {

struct LiveSource {
  std::string name;  ///< see kinectOf()
  tracking::DepthStreamOptions stream;
};

/// Opened cameras, and what happens to them: each fault is reported once, as soon as it is known.
/// One thread.
class LiveCameras {
 public:
  /// Throws ParseError, and UsageError, also for the same camera twice and for several without poses.
  explicit LiveCameras(const std::vector<LiveSource>& sources);

  tracking::LiveMoments& moments() { return moments_; }
  const std::string& name() const { return names_.front(); }
  std::string names() const;
  const std::vector<std::string>& allNames() const { return names_; }  ///< of all cameras, with "and"
  std::size_t size() const { return names_.size(); }
  std::size_t dropped() const { return moments_.dropped(); }  ///< images of all cameras
  std::vector<tracking::DepthCamera> cameras() const;
  const tracking::DepthFacts& facts() const { return moments_.camera(0).facts(); }  ///< of the first

  /// One sentence for each camera that hangs since the last call, and for each of several that has ended, was
  /// moved, disagrees with the others or is late.
  std::vector<std::string> news(std::span<const tracking::CameraShare> shares);
  const std::vector<std::string>& reported() const { return reported_; }
  /// True if no camera has usable images any more.
  bool isOver(std::span<const tracking::CameraShare> shares) const;
  /// Why: of each camera, with semicolons; empty if it is not over.
  std::string ended(std::span<const tracking::CameraShare> shares) const;

  /// An array with an object for each camera.
  nlohmann::ordered_json json(const tracking::ClipTrack& track) const;
  /// A line for each of several cameras; empty for one.
  std::string text(const tracking::ClipTrack& track) const;

 private:
  /// Why the camera has no usable images any more; empty if it has.
  std::string failureOf(std::size_t c, std::span<const tracking::CameraShare> shares) const;

  std::vector<std::string> names_;
  tracking::LiveMoments moments_;
  std::vector<bool> has_failed_, has_hung_, is_apart_, is_late_;  ///< it was reported
  std::vector<std::string> reported_;
};

}  // namespace abstand::cli
