// Tracks people in live depth images.
#pragma once

#include <functional>
#include <map>
#include <optional>

#include "tracking/tracker/camera_stand.hpp"
#include "tracking/tracker/clip_tracker.hpp"

namespace abstand::tracking {

struct LiveTrackerOptions {
  TrackedPerson::Options person;
  bool keep{true};                               ///< keep the frames of all people, for track()
  std::function<void(const ClipMoment&)> watch;  ///< may be empty
};

/// Single pass over live images: each person is first measured, then tracked with the usual body of that
/// stature, and after some seconds with the fitted one. One thread. Allocates while a person is measured and
/// fitted, and if frames are kept.
class LiveTracker {
 public:
  /// `camera`: that of the images; `pose_known`: its X_WC is in the world, otherwise estimated from the first
  /// images.
  LiveTracker(const DepthCamera& camera, bool pose_known, const LiveTrackerOptions& options);

  /// A person found in the last image.
  struct Seen {
    int id;  ///< id from PeopleFinder
    const TrackedBody* body;
  };
  /// `frame.t` (s) increases. The result is valid until the next call; empty before the world is decided.
  std::span<const Seen> see(const DepthFrame& frame);

  /// The tracks so far. With frames only if they are kept.
  ClipTrack track() const;

 private:
  struct Follower {
    explicit Follower(const TrackedPerson::Options& options) : person(options) {}
    TrackedPerson person;
    double last{0.0};  ///< s, last time in view
  };
  void forget(double t);

  LiveTrackerOptions options_;
  std::optional<CameraStand> stand_;  ///< as long as the world is not decided
  std::optional<PeopleFinder> finder_;
  ClipTrack track_;
  std::map<int, Follower> followers_;
  std::map<int, std::size_t> place_;  ///< index in track_.people of each person
  std::vector<std::uint8_t> mask_;
  std::vector<Seen> seen_;
};

}  // namespace abstand::tracking
