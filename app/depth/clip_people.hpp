// People of a depth clip: recorded joints, and skin bodies.
#pragma once

#include "app/session/session.hpp"
#include "tracking/depth/simulator/skin_body.hpp"

namespace abstand::depth {

/// Joints of each person of a session over time. The session must outlive this object.
class ClipPeople {
 public:
  explicit ClipPeople(const session::Session& session);

  std::size_t size() const { return people_.size(); }
  /// Recorded joints at or just before `t`, in world, with the time t; for a person without a recording those
  /// of its model in the rest pose.
  humanmodel::SkeletonFrame at(std::size_t person, double t) const;
  /// Stature (m) from the recorded legs, otherwise the model's.
  double stature(std::size_t person) const;

 private:
  struct Person {
    const session::HumanDriver* driver;
    Transform X_WR;  ///< recording in world
  };
  std::vector<Person> people_;
};

/// A scene with one person who follows a recording: in the first frame with hips these are above the origin,
/// facing +x; the floor z = 0 is the height of the lowest skin in nine tenths of the frames. With a `height`
/// (m) the recording is scaled so that the length of its legs fits that stature. Throws ParseError and
/// UsageError.
scene_file::SceneDescription sceneOf(const std::filesystem::path& recording, std::optional<double> height);

}  // namespace abstand::depth
