// Tracks people in live depth images.
#pragma once

#include <functional>
#include <map>
#include <optional>

#include "tracking/tracker/camera_stand.hpp"
#include "tracking/tracker/clip_tracker.hpp"
#include "tracking/tracker/live_agreement.hpp"
#include "tracking/tracker/shown_things.hpp"

namespace abstand::tracking {

struct LiveTrackerOptions {
  TrackedPerson::Options person;
  bool keep{true};      ///< keep the frames of all people, for track()
  KnownThings known;    ///< removed from the images that show them (ShownThings); may be empty
  KnownThings at_rest;  ///< those of them whose displacement is measured; may be empty
  std::function<void(const ClipMoment&)> watch;  ///< may be empty
};

/// Single pass over live images of one or several cameras: each person is first measured, then tracked with
/// the usual body of that stature, and after some seconds with the fitted one. Several cameras are compared
/// with each other (LiveAgreement): the images of one that disagrees are not used, and the spread of the
/// joints grows as in recordings. One thread, and those of LiveAgreement and TrackedPerson if options.person
/// says fit_aside. Allocates while a person is measured and fitted, and if frames are kept.
class LiveTracker {
 public:
  /// `cameras`: those of the images, 1 to BodyObservation::kMaxViews; `poses_known`: their X_WC are in one
  /// world. Of one camera without a pose it is estimated from the first images. Throws UsageError.
  LiveTracker(std::span<const DepthCamera> cameras, bool poses_known, const LiveTrackerOptions& options);

  /// A person found at the last moment.
  struct Seen {
    int id;  ///< of PeopleViews
    const TrackedBody* body;
    /// The joints of the body. Their spread includes that of the cameras' poses and what the joints moved
    /// between the images of several cameras.
    humanmodel::SkeletonFrame frame;
  };
  /// `moment.t` (s) increases. The result is valid until the next call; empty before the world is decided.
  std::span<const Seen> see(const DepthMoment& moment);
  /// The same for one camera.
  std::span<const Seen> see(const DepthFrame& frame);

  /// Shares of the cameras so far; one that was moved is not used any more.
  std::span<const CameraShare> shares() const { return track_.cameras; }
  /// Whether the images of each camera show LiveTrackerOptions::known; of one whose pose is not known yet,
  /// nothing is compared.
  std::span<const ShownThings> shown() const { return shown_; }
  /// The tracks so far. With frames only if they are kept.
  ClipTrack track() const;

 private:
  struct Follower {
    explicit Follower(const TrackedPerson::Options& options) : person(options) {}
    TrackedPerson person;
    double last{0.0};                  ///< s, last time in view
    humanmodel::SkeletonFrame before;  ///< of the last moment with the body
  };
  bool decideWorld(const DepthMoment& moment);
  const DepthImage* knownFor(const DepthMoment& moment, const DepthCamera& camera);
  void judgeCameras(double t);
  void follow(const DepthMoment& moment, int id, std::size_t first, std::span<const PersonImage> images);
  void forget(double t);

  LiveTrackerOptions options_;
  std::optional<CameraStand> stand_;  ///< as long as the world is not decided
  std::vector<DepthCamera> cameras_;
  std::vector<ShownThings> shown_;  ///< of each camera
  std::vector<BandedThings> banded_;
  std::vector<const DepthImage*> known_now_;  ///< in the images of the last moment; null: nothing
  std::optional<PeopleViews> views_;
  std::unique_ptr<LiveAgreement> agreement_;  ///< null: there is one camera
  std::vector<CameraFault> faults_;
  ClipTrack track_;
  std::map<int, Follower> followers_;
  std::map<int, std::size_t> place_;  ///< index in track_.people of each person
  std::vector<Seen> seen_;
};

}  // namespace abstand::tracking
