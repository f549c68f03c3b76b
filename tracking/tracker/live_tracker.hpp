// People of a camera that looks now, image by image.
#pragma once

#include <functional>
#include <map>
#include <optional>

#include "tracking/tracker/camera_stand.hpp"
#include "tracking/tracker/clip_tracker.hpp"

namespace abstand::tracking {

struct LiveTrackerOptions {
  TrackedPerson::Options person;
  bool keep{true};                               ///< the frames of all people, for track()
  std::function<void(const ClipMoment&)> watch;  ///< may be empty
};

/// One walk through the images as they come, nothing is seen twice: everybody is measured first, then
/// followed with the usual body of that height, and after some seconds with the fitted one. One thread.
/// Allocates while somebody is measured and fitted, and where frames are kept.
class LiveTracker {
 public:
  /// `camera`: of the images; `pose_known`: its X_WC is that of the world, else the first images decide.
  LiveTracker(const DepthCamera& camera, bool pose_known, const LiveTrackerOptions& options);

  /// Who was found in the last image.
  struct Seen {
    int id;  ///< as of PeopleFinder
    const TrackedBody* body;
  };
  /// `frame.t` (s) rises. The result is there until the next call; empty before the world is decided.
  std::span<const Seen> see(const DepthFrame& frame);

  /// What was tracked so far. Frames only where they are kept.
  ClipTrack track() const;

 private:
  struct Follower {
    explicit Follower(const TrackedPerson::Options& options) : person(options) {}
    TrackedPerson person;
    double last{0.0};  ///< s, when in view
  };
  void forget(double t);

  LiveTrackerOptions options_;
  std::optional<CameraStand> stand_;  ///< while the world is not decided
  std::optional<PeopleFinder> finder_;
  ClipTrack track_;
  std::map<int, Follower> followers_;
  std::map<int, std::size_t> place_;  ///< of a person in track_.people
  std::vector<std::uint8_t> mask_;
  std::vector<Seen> seen_;
};

}  // namespace abstand::tracking
