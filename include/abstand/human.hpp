// People: fourteen rigid parts from the stature, laid along the joints of a skeleton.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "abstand/mesh.hpp"
#include "abstand/skeleton.hpp"

namespace abstand {

/// Whom to make.
struct HumanOptions {
  /// Of whom the sizes are.
  enum class Sex { kFemale, kMale, kMean };

  double height{1.75};         ///< m, 0.5 to 2.5
  std::optional<double> mass;  ///< kg, 10 to 300; none: from height and sex
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

/// A person's body. Constant, shared by copies; any thread.
class Human {
 public:
  /// Throws std::runtime_error for a height or a mass out of range, or that do not fit each other.
  explicit Human(const HumanOptions& options = {});
  double height() const;                        ///< m
  double mass() const;                          ///< kg
  const std::vector<HumanPart>& parts() const;  ///< fourteen: torso, head, then limbs, left before right
  /// Standing, arms down, facing +x, feet on z = 0, pelvis over the origin.
  Skeleton rest() const;

  /// @cond library
  struct Impl;
  const Impl& impl() const { return *impl_; }
  /// @endcond

 private:
  std::shared_ptr<const Impl> impl_;
};

/// How a part's pose came about. kNone: never seen, the pose means nothing. kHeld: its joints are missing,
/// the last pose stands, which is never safe. kInferred: the tracker guessed a joint. kTracked: measured.
enum class PartState : std::uint8_t { kNone, kHeld, kInferred, kTracked };

/// Where the parts are.
struct HumanPose {
  std::vector<Pose> X_WP;        ///< of each part, in the order of Human::parts()
  std::vector<PartState> state;  ///< likewise
  std::vector<double> age;       ///< s since the part was last seen; infinite before the first time
};

/// Lays the parts of a person along skeletons. Joints follow the skeleton's directions and keep the model's
/// lengths; hips are lifted by the ratio of leg lengths. For one person, and one thread at a time.
class HumanPoser {
 public:
  /// `follow_lengths`: joints stand where the skeleton has them.
  explicit HumanPoser(const Human& human, bool follow_lengths = false);
  ~HumanPoser();
  HumanPoser(HumanPoser&& other) noexcept;             ///< the other can only be assigned to
  HumanPoser& operator=(HumanPoser&& other) noexcept;  ///< likewise
  /// Takes the sizes of legs from the whole of a recording instead of from every frame for itself.
  void calibrate(const std::vector<Skeleton>& recording);
  /// Skeletons come in the order of time. A skeleton with numbers that are not finite changes nothing but
  /// state and age.
  HumanPose pose(const Skeleton& skeleton);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace abstand
