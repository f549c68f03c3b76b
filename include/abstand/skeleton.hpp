// One moment of a person: where the joints are.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "abstand/pose.hpp"

namespace abstand {

/// Joint centres of a person. kHead is the middle of the head, kHeadTop the vertex; kHand the end of the
/// hand; kToe the ball of the foot or the tip of the toes.
enum class Joint : std::uint8_t {
  kPelvis,
  kSpine,
  kThorax,
  kNeck,
  kHead,
  kHeadTop,
  kShoulderLeft,
  kElbowLeft,
  kWristLeft,
  kHandLeft,
  kShoulderRight,
  kElbowRight,
  kWristRight,
  kHandRight,
  kHipLeft,
  kKneeLeft,
  kAnkleLeft,
  kToeLeft,
  kHipRight,
  kKneeRight,
  kAnkleRight,
  kToeRight,
  kCount
};
/// Number of joints.
inline constexpr std::size_t kJoints = static_cast<std::size_t>(Joint::kCount);

/// "pelvis", "shoulder_left", ...
std::string jointName(Joint joint);
/// The joint of this name, or none.
std::optional<Joint> findJoint(const std::string& name);

/// How much is known of a joint. kMissing: nothing in this moment. kInferred: a tracker guessed it. kTracked:
/// it was measured.
enum class JointState : std::uint8_t { kMissing, kInferred, kTracked };

/// All joints at one time; a new one has none. World z up, m, right-handed. A value.
struct Skeleton {
  double t{0.0};                            ///< s
  std::array<Eigen::Vector3d, kJoints> p;   ///< m; NaN where missing
  std::array<JointState, kJoints> state{};  ///< of each joint
  std::array<double, kJoints> spread{};     ///< m, standard deviation along the worst axis; 0: not known

  /// Without any joint.
  Skeleton() { p.fill(Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN())); }
  /// Puts a joint to a point (m).
  void set(Joint joint, const Eigen::Vector3d& point, JointState s = JointState::kTracked) {
    p[static_cast<std::size_t>(joint)] = point;
    state[static_cast<std::size_t>(joint)] = s;
  }
};

}  // namespace abstand
