// Moves the parts of a person along a recording.
#pragma once

#include "app/scene_file/scene_description.hpp"
#include "core/scene/scene.hpp"
#include "humanmodel/poser.hpp"
#include "tracking/tracker/known_objects.hpp"
#include "tracking/tracker/track_monitor.hpp"

namespace abstand::session {

/// One person of a session. Loop thread only.
class HumanDriver {
 public:
  /// Reads the recording (if any) and builds the model. `known`: depth images of known objects, for a depth
  /// camera in the scene. Throws ParseError, UsageError, and Interrupted if the monitor ends the tracking.
  explicit HumanDriver(const scene_file::HumanDescription& description,
                       const tracking::KnownObjects& known = {}, const tracking::TrackMonitor& monitor = {});
  HumanDriver(const HumanDriver&) = delete;
  HumanDriver& operator=(const HumanDriver&) = delete;

  /// Place of the recording in the world from the next pose on, as RecordingDescription says it.
  void setPlace(const Vector3d& xyz, double yaw) { X_WR_ = fromXyzRpy(xyz, Vector3d(0, 0, yaw)); }
  void bind(humanmodel::BodyPart part, ObjectId object) { objects_[static_cast<std::size_t>(part)] = object; }

  /// Binds a tool, which moves with a hand. `X_HT`: tool in the hand's frame; `reach`: m, distance of its
  /// farthest point from the hand's centre.
  void hold(humanmodel::BodyPart hand, ObjectId object, const Transform& X_HT, double reach);

  /// Poses all parts and tools at time t from the recorded frame at or just before t. Parts missing in the
  /// recording are marked stale. No allocation, no throw.
  void apply(double t, scene::Scene& scene);
  /// The same with linear interpolation of joints between two recorded frames, so that velocities are those
  /// of the person, independent of the camera's frame rate. Joints missing in one of them are taken from the
  /// earlier frame.
  void interpolate(double t, scene::Scene& scene);
  /// Poses all parts from a live skeleton in the frame of the recording; its time is `t`. The first call
  /// discards the state from the recording. No allocation, no throw.
  void follow(const humanmodel::SkeletonFrame& frame, scene::Scene& scene);
  /// Marks all parts as stale; their pose uncertainty grows from the time they were last seen.
  void markStale(double t, scene::Scene& scene) const;
  /// Updates the pose uncertainty of all parts and tools to time t, without changing poses: age x speed plus
  /// the quantile of their spread (humanmodel/part_uncertainty.hpp). The speed of a part is its bound in the
  /// scene. No allocation, no throw.
  void growUncertainty(double t, scene::Scene& scene) const;
  /// s, longest time since a part was last seen in the recording; parts not seen so far do not count.
  double recordedAge() const;
  /// s, at time t, longest time since a part was last seen by follow(); infinite before the first call.
  double liveAge(double t) const;

  /// An object of the person, and the part that it is, or the hand that holds it.
  struct Body {
    ObjectId object;
    humanmodel::BodyPart part;
    bool tool{false};
  };
  /// Parts in their order, then tools.
  std::vector<Body> bodies() const;

  /// m/s, for each of bodies(): upper bound on the speed of its fastest point between any two successive
  /// frames of the recording in which its part was seen. 0 without a recording. Looks at every frame.
  std::vector<double> recordedSpeeds(const scene::Scene& scene) const;

  const humanmodel::HumanModel& model() const { return model_; }
  /// Null for a person without a recording.
  const tracking::Recording* recording() const { return recording_ ? &*recording_ : nullptr; }
  /// Bodies fitted to the images of a depth recording; null for any other recording, or if not kept
  /// (SessionOptions::keep_fits).
  const std::shared_ptr<const tracking::FittedClip>& fitted() const { return fitted_; }
  void keepFitted(std::shared_ptr<const tracking::FittedClip> fitted) { fitted_ = std::move(fitted); }
  std::optional<ObjectId> object(humanmodel::BodyPart part) const {
    return objects_[static_cast<std::size_t>(part)];
  }

 private:
  struct Held {
    humanmodel::BodyPart hand;
    ObjectId object;
    Transform X_HT;
    double reach, lever;  ///< m, as in heldUncertainty()
  };

  /// Pose of a part in the recording's frame; a part never seen is placed on the torso as in the rest pose.
  Transform poseOf(std::size_t part) const;
  void place(double t, scene::Scene& scene) const;
  void show(const humanmodel::SkeletonFrame& frame, double t, scene::Scene& scene);

  std::optional<tracking::Recording> recording_;
  std::shared_ptr<const tracking::FittedClip> fitted_;
  humanmodel::HumanModel model_;
  humanmodel::Poser poser_;
  humanmodel::HumanPose pose_;
  humanmodel::HumanPose standing_;
  Transform X_WR_;  ///< recording in world
  double last_t_{-kInfinity};
  bool followed_{false};
  std::array<std::optional<ObjectId>, humanmodel::kBodyPartCount> objects_;
  std::vector<Held> held_;
};

}  // namespace abstand::session
