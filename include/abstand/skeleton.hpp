// Joint positions of a person at one time.
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
/// The joint with this name; empty if there is none.
std::optional<Joint> findJoint(const std::string& name);

/// State of a joint. kMissing: no position at this time. kInferred: a tracker estimated it without seeing it.
/// kTracked: measured.
enum class JointState : std::uint8_t { kMissing, kInferred, kTracked };

/// All joints at one time; initially all are missing. World z up, m, right-handed. A value.
struct Skeleton {
  double t{0.0};                            ///< s
  std::array<Eigen::Vector3d, kJoints> p;   ///< m; NaN if missing
  std::array<JointState, kJoints> state{};  ///< of each joint
  std::array<double, kJoints> spread{};     ///< m, standard deviation along the worst axis; 0: unknown
  /// Unit vectors, world: the y axis of the body part that ends at the joint, if the orientations of a
  /// recording state it. Determines the twist of the part. Zero: not stated.
  std::array<Eigen::Vector3f, kJoints> lateral;

  /// All joints missing.
  Skeleton() {
    p.fill(Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
    lateral.fill(Eigen::Vector3f::Zero());
  }
  /// Sets the position (m) and state of a joint.
  void set(Joint joint, const Eigen::Vector3d& point, JointState s = JointState::kTracked) {
    p[static_cast<std::size_t>(joint)] = point;
    state[static_cast<std::size_t>(joint)] = s;
  }
};

}  // namespace abstand
