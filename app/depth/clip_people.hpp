// The people of a depth clip: their joints as recorded, and their skin.
#pragma once

#include "app/session/session.hpp"
#include "tracking/depth/simulator/skin_body.hpp"

namespace abstand::depth {

/// The joints of each person of a session, moment by moment. The session must outlive this.
class ClipPeople {
 public:
  explicit ClipPeople(const session::Session& session);

  std::size_t size() const { return people_.size(); }
  /// The recorded joints at or just before `t`, in world, with t itself as time; of a person without a
  /// recording those of its model, standing.
  humanmodel::SkeletonFrame at(std::size_t person, double t) const;
  /// m, of the legs where they were recorded, else the model's.
  double stature(std::size_t person) const;

 private:
  struct Person {
    const session::HumanDriver* driver;
    Transform X_WR;  ///< recording in world
  };
  std::vector<Person> people_;
};

/// A scene of one person who moves after a recording: the first frame that shows hips over the origin, facing
/// +x, and the feet on z = 0 as they are nine tenths of the time. With a `height` (m) the recording is scaled
/// until its legs are those of that stature. Throws ParseError and UsageError.
scene_file::SceneDescription sceneOf(const std::filesystem::path& recording, std::optional<double> height);

}  // namespace abstand::depth
