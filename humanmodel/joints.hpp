// The canonical skeleton, to which every recording is mapped.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "core/math/transform.hpp"

namespace abstand::humanmodel {

/// Joint centres. kHead is the middle of the head, kHeadTop the vertex; kHand the tip of the middle finger's
/// knuckle or the end of the hand; kToe the ball of the foot or the toe tip.
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
inline constexpr std::size_t kJointCount = static_cast<std::size_t>(Joint::kCount);

/// "pelvis", "shoulder_left", ...
std::string_view jointName(Joint joint);
std::optional<Joint> parseJoint(std::string_view name);

/// missing: no data in this frame. inferred: guessed by the tracker. tracked: measured.
enum class JointState : std::uint8_t { kMissing, kInferred, kTracked };

/// A vector or matrix for each joint, all zero at first, when it takes no memory of its own: few recordings
/// state any. Copies are deep. The first write allocates.
template <typename Value>
class JointValues {
 public:
  JointValues() = default;
  JointValues(const JointValues& other) : all_(other.all_ ? std::make_unique<All>(*other.all_) : nullptr) {}
  JointValues(JointValues&&) noexcept = default;
  JointValues& operator=(const JointValues& other) {
    if (all_ && other.all_)
      *all_ = *other.all_;
    else
      all_ = other.all_ ? std::make_unique<All>(*other.all_) : nullptr;
    return *this;
  }
  JointValues& operator=(JointValues&&) noexcept = default;
  ~JointValues() = default;

  /// Any was written.
  bool isStated() const { return all_ != nullptr; }
  const Value& operator[](std::size_t joint) const {
    static const Value kZero = Value::Zero();
    return all_ ? (*all_)[joint] : kZero;
  }
  Value& operator[](std::size_t joint) {
    if (!all_) {
      all_ = std::make_unique<All>();
      all_->fill(Value::Zero());
    }
    return (*all_)[joint];
  }

 private:
  using All = std::array<Value, kJointCount>;
  std::unique_ptr<All> all_;
};
using JointMatrices = JointValues<Matrix3d>;
using JointDirections = JointValues<Eigen::Vector3f>;

/// Joints of a person at one time: world axes after conversion (z up, metres, right-handed). A missing joint
/// is NaN and never used as a position.
struct SkeletonFrame {
  double t{0.0};  ///< s since the start of the recording
  std::array<Vector3d, kJointCount> p;
  std::array<JointState, kJointCount> state;
  std::array<double, kJointCount> spread;  ///< m, standard deviation along the worst axis; 0: unknown
  /// m^2, of the error, in the axes of `p`; read by covarianceOf(). Zero: the spread in all directions.
  JointMatrices covariance;
  /// Unit vectors in the axes of `p`: the y axis of the body part that ends at the joint (of a forearm: at
  /// the wrist), as the orientations of a file state it. Determines the twist of the part. Zero: not stated.
  JointDirections lateral;

  SkeletonFrame() {
    p.fill(Vector3d::Constant(kNaN));
    state.fill(JointState::kMissing);
    spread.fill(0.0);
  }
  const Vector3d& operator[](Joint j) const { return p[static_cast<std::size_t>(j)]; }
  bool has(Joint j) const { return state[static_cast<std::size_t>(j)] != JointState::kMissing; }
  void set(Joint j, const Vector3d& p_WJ, JointState s = JointState::kTracked) {
    p[static_cast<std::size_t>(j)] = p_WJ;
    state[static_cast<std::size_t>(j)] = s;
  }
};

}  // namespace abstand::humanmodel
