// People: fourteen rigid parts scaled by stature, posed along the joints of a skeleton.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "abstand/mesh.hpp"
#include "abstand/skeleton.hpp"

namespace abstand {

/// Parameters of a body.
struct HumanOptions {
  /// Population of the body dimensions.
  enum class Sex { kFemale, kMale, kMean };

  double height{1.75};         ///< m, 0.5 to 2.5
  std::optional<double> mass;  ///< kg, 10 to 300; empty: from height and sex
  Sex sex{Sex::kMean};         ///< kMean: the mean of both
  bool thesis{false};          ///< the proportions of the thesis (table B.1) instead of those of ANSUR II
};

/// One part in its own frame P: origin at the centre of the shape, z from the distal to the proximal joint, x
/// forward, y left (standing, arms down).
struct HumanPart {
  std::string name;                                         ///< "torso", "forearm_left", ...
  Shape shape{Shape::sphere(1.0)};                          ///< an ellipsoid or a cuboid
  double mass{0.0};                                         ///< kg
  Eigen::Vector3d centre_of_mass{Eigen::Vector3d::Zero()};  ///< m, in P
};

/// Body of a person. Constant, shared by copies; any thread.
class Human {
 public:
  /// Throws std::runtime_error if height or mass is out of range, or if they are not consistent.
  explicit Human(const HumanOptions& options = {});
  double height() const;                        ///< m
  double mass() const;                          ///< kg
  const std::vector<HumanPart>& parts() const;  ///< fourteen: torso, head, then limbs, left before right
  /// Rest pose: standing, arms down, facing +x, feet on z = 0, pelvis over the origin.
  Skeleton rest() const;

  /// @cond library
  struct Impl;
  const Impl& impl() const { return *impl_; }
  /// @endcond

 private:
  std::shared_ptr<const Impl> impl_;
};

/// Origin of the pose of a part. kNone: never seen, the pose is undefined. kHeld: its joints are missing and
/// the last pose is kept, which never counts as safe. kInferred: the tracker estimated a joint without seeing
/// it. kTracked: measured.
enum class PartState : std::uint8_t { kNone, kHeld, kInferred, kTracked };

/// Poses of all parts.
struct HumanPose {
  std::vector<Pose> X_WP;        ///< of each part, in the order of Human::parts()
  std::vector<PartState> state;  ///< likewise
  std::vector<double> age;       ///< s since the part was last seen; infinite before the first time
};

/// Poses the parts of a person along skeletons. Joints follow the directions of the skeleton with the lengths
/// of the model; the height of the hips is scaled by the ratio of the leg lengths. For one person, and one
/// thread at a time.
class HumanPoser {
 public:
  /// `follow_lengths`: the joints are at the positions of the skeleton.
  explicit HumanPoser(const Human& human, bool follow_lengths = false);
  ~HumanPoser();
  HumanPoser(HumanPoser&& other) noexcept;             ///< `other` can then only be assigned to
  HumanPoser& operator=(HumanPoser&& other) noexcept;  ///< likewise
  /// Determines the leg lengths from a whole recording instead of from each frame.
  void calibrate(const std::vector<Skeleton>& recording);
  /// Skeletons are in order of time. A skeleton with values that are not finite changes only state and age.
  HumanPose pose(const Skeleton& skeleton);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace abstand
