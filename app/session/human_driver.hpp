// Moves a person's parts after a recording.
#pragma once

#include "app/scene_file/scene_description.hpp"
#include "core/scene/scene.hpp"
#include "humanmodel/poser.hpp"
#include "tracking/tracker/clip_tracker.hpp"
#include "tracking/tracker/track_monitor.hpp"

namespace abstand::session {

/// One person of a session. Loop thread only.
class HumanDriver {
 public:
  /// Reads the recording (if any) and makes the model. `known`: what a depth camera that stands in the scene
  /// sees of other things. Throws ParseError, UsageError, and Interrupted when the monitor ends the tracking.
  explicit HumanDriver(const scene_file::HumanDescription& description,
                       const tracking::KnownThings& known = {}, const tracking::TrackMonitor& monitor = {});
  HumanDriver(const HumanDriver&) = delete;
  HumanDriver& operator=(const HumanDriver&) = delete;

  void bind(humanmodel::BodyPart part, ObjectId object) { objects_[static_cast<std::size_t>(part)] = object; }

  /// Poses all parts for time t: the recorded frame at or just before t. A part that the recording does not
  /// show is marked stale. No allocation, no throw.
  void apply(double t, scene::Scene& scene);
  /// The same between two recorded frames, on the straight line between their joints, so that velocities are
  /// those of the person and not of the camera. Joints that one of the two lacks stay those of the earlier
  /// one.
  void glide(double t, scene::Scene& scene);
  /// Poses all parts after a skeleton from outside, in the frame of the recording; the frame's t is `t`. What
  /// the recording showed is forgotten at the first. No allocation, no throw.
  void follow(const humanmodel::SkeletonFrame& frame, scene::Scene& scene);
  /// Says of all parts that where they are is no longer known; their pose uncertainty grows from when they
  /// were seen.
  void lose(double t, scene::Scene& scene) const;
  /// Widens the pose uncertainty of all parts, whose poses stay, to time t: age x speed and the quantile of
  /// their spread (humanmodel/part_uncertainty.hpp). The speed of a part is its bound in the scene. No
  /// allocation, no throw.
  void widen(double t, scene::Scene& scene) const;
  /// s, since that part was seen in the recording which has been missing for longest; parts that the
  /// recording has not shown so far do not count.
  double missing() const;
  /// s, at time t, since the part that was not seen for longest was seen by follow(); infinite before that.
  double unseen(double t) const;

  const humanmodel::HumanModel& model() const { return model_; }
  /// Null for a person who stands still.
  const tracking::Recording* recording() const { return recording_ ? &*recording_ : nullptr; }
  std::optional<ObjectId> object(humanmodel::BodyPart part) const {
    return objects_[static_cast<std::size_t>(part)];
  }

 private:
  /// Of a part, in the recording's frame; one that was never seen hangs on the torso as when standing.
  Transform poseOf(std::size_t part) const;
  void place(double t, scene::Scene& scene) const;
  void show(const humanmodel::SkeletonFrame& frame, double t, scene::Scene& scene);

  std::optional<tracking::Recording> recording_;
  humanmodel::HumanModel model_;
  humanmodel::Poser poser_;
  humanmodel::HumanPose pose_;
  humanmodel::HumanPose standing_;
  Transform X_WR_;  ///< recording in world
  double last_t_{-kInfinity};
  bool followed_{false};
  std::array<std::optional<ObjectId>, humanmodel::kBodyPartCount> objects_;
};

}  // namespace abstand::session
