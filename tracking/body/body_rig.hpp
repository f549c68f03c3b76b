// Kinematic rig of a person: rigid segments that are fitted to joints, markers and depth.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "humanmodel/human_model.hpp"

namespace abstand::tracking {

/// Parents precede their children. The torso of the model is two segments here, as people bend.
enum class RigSegment : std::uint8_t {
  kPelvis,
  kChest,
  kHead,
  kUpperArmLeft,
  kUpperArmRight,
  kForearmLeft,
  kForearmRight,
  kHandLeft,
  kHandRight,
  kThighLeft,
  kThighRight,
  kCalfLeft,
  kCalfRight,
  kFootLeft,
  kFootRight,
  kCount
};
inline constexpr std::size_t kRigSegments = static_cast<std::size_t>(RigSegment::kCount);
constexpr std::size_t index(RigSegment s) { return static_cast<std::size_t>(s); }
constexpr RigSegment segmentAt(std::size_t i) { return static_cast<RigSegment>(i); }

/// +1 left, -1 right, 0 for pelvis, chest and head.
constexpr int sideOf(RigSegment s) { return index(s) < 3 ? 0 : (index(s) % 2 == 1 ? 1 : -1); }

std::string_view segmentName(RigSegment s);

/// Joint of a segment to its parent. free: the pelvis, six dof. ball: three. hinges: one or two axes in
/// sequence.
enum class RigJoint : std::uint8_t { kFree, kBall, kHinges };

/// A segment's frame S: origin at the joint to its parent (pelvis: hip centre), axes those of the world when
/// standing: x forward, y left, z up. Lengths in m, angles in rad.
struct RigPart {
  RigSegment parent{RigSegment::kPelvis};  ///< for the pelvis: itself
  RigJoint joint{RigJoint::kBall};
  int column{0};                           ///< index of its first dof
  int freedoms{3};                         ///< number of dof
  Vector3d p_parent{Vector3d::Zero()};     ///< the joint in the parent's frame
  std::array<Vector3d, 2> axis{};          ///< of hinges, unit vectors in the parent's frame at angle 0
  std::array<double, 2> lower{}, upper{};  ///< limits of hinges
  Vector3d along{-Vector3d::UnitZ()};      ///< of a ball: axis of the segment, in S ...
  Vector3d middle{-Vector3d::UnitZ()};     ///< ... centre of its allowed directions, in the parent's frame
  double cone{kPi};                        ///< ... largest swing angle from the centre
  double twist{kPi};                       ///< ... largest twist about itself
  geometry::Shape shape{geometry::Sphere{0.01}};  ///< visible shape
  Vector3d p_shape{Vector3d::Zero()};             ///< its centre, in S; its axes are those of S
};

inline constexpr int kRigDof = 6 + 3 + 3 + 2 * (3 + 1 + 2) + 2 * (3 + 1 + 2);

/// A model divided into segments. Constant after construction.
struct BodyRig {
  std::array<RigPart, kRigSegments> parts;
  /// For each canonical joint: the segment that carries it and its position there (m). Shoulders, neck and
  /// thorax belong to the chest; hips, pelvis and spine to the pelvis; an elbow to the upper arm, and so on.
  std::array<RigSegment, humanmodel::kJointCount> carrier;
  std::array<Vector3d, humanmodel::kJointCount> p_joint;
  double height{0.0};  ///< m, stature

  const RigPart& operator[](RigSegment s) const { return parts[index(s)]; }
};

/// Joint limits are the widest of healthy adults (Boone, Azen 1979; Kapandji), plus 10 degrees, as a
/// person's neutral pose differs from the model's.
BodyRig makeRig(const humanmodel::HumanModel& model);

/// Pose of the rig: joint coordinates.
struct RigPose {
  Transform X_WP{Transform::Identity()};       ///< of the pelvis
  std::array<Quaterniond, kRigSegments> R_PS;  ///< of balls: from the segment's axes to the parent's
  std::array<std::array<double, 2>, kRigSegments> angle{};  ///< of hinges, rad

  RigPose() { R_PS.fill(Quaterniond::Identity()); }
};

/// Poses of all segments in the world.
using RigPlacement = std::array<Transform, kRigSegments>;

/// Forward kinematics. No allocation, no throw.
void place(const BodyRig& rig, const RigPose& pose, RigPlacement& X_WS);
/// Of one segment that is not the pelvis, at the pose that X_WS has for its parent.
void placeSegment(const BodyRig& rig, const RigPose& pose, RigSegment segment, RigPlacement& X_WS);

/// World position (m) of a canonical joint. No allocation, no throw.
Vector3d jointPosition(const BodyRig& rig, const RigPlacement& X_WS, humanmodel::Joint joint);

/// Positions of the canonical joints, all with state `state`; `t` is unchanged.
void jointsOf(const BodyRig& rig, const RigPlacement& X_WS, humanmodel::JointState state,
              humanmodel::SkeletonFrame& frame);

}  // namespace abstand::tracking
