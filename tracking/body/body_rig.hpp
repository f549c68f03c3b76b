// The person as a chain of rigid segments: what is fitted to joints, markers and depth.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "humanmodel/human_model.hpp"

namespace abstand::tracking {

/// A parent stands before its children. The torso of the model is two segments here, as people bend.
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

/// How a segment turns on its parent. free: the pelvis, six degrees of freedom. ball: three. hinges: one or
/// two axes, one after the other.
enum class RigJoint : std::uint8_t { kFree, kBall, kHinges };

/// A segment's frame S: origin at the joint that ties it to its parent (pelvis: the middle of the hips), axes
/// those of the world when standing: x forward, y left, z up. Lengths in m, angles in rad.
struct RigPart {
  RigSegment parent{RigSegment::kPelvis};  ///< of the pelvis: itself
  RigJoint joint{RigJoint::kBall};
  int column{0};                          ///< first of its degrees of freedom
  int freedoms{3};                        ///< how many
  Vector3d p_parent{Vector3d::Zero()};    ///< the joint in the parent's frame
  std::array<Vector3d, 2> axis{};         ///< of hinges, unit vectors of the parent's frame when at 0
  std::array<double, 2> least{}, most{};  ///< of hinges
  Vector3d along{-Vector3d::UnitZ()};     ///< of a ball: the axis of the segment, in S ...
  Vector3d middle{-Vector3d::UnitZ()};    ///< ... the middle of where it may point, in the parent's frame
  double cone{kPi};                       ///< ... the most that it may be away from there
  double twist{kPi};                      ///< ... and the most that it may turn about itself
  geometry::Shape shape{geometry::Sphere{0.01}};  ///< what a camera sees of it
  Vector3d p_shape{Vector3d::Zero()};             ///< its centre, in S; its axes are those of S
};

inline constexpr int kRigDof = 6 + 3 + 3 + 2 * (3 + 1 + 2) + 2 * (3 + 1 + 2);

/// A model cut into segments. Constant after construction.
struct BodyRig {
  std::array<RigPart, kRigSegments> parts;
  /// Each canonical joint: the segment that carries it and its place there (m). Shoulders, neck and thorax
  /// are the chest's, hips, pelvis and spine the pelvis's, an elbow the upper arm's, and so on.
  std::array<RigSegment, humanmodel::kJointCount> carrier;
  std::array<Vector3d, humanmodel::kJointCount> p_joint;
  double height{0.0};  ///< m

  const RigPart& operator[](RigSegment s) const { return parts[index(s)]; }
};

/// The limits of the joints are the widest that healthy adults reach (Boone, Azen 1979; Kapandji), with 10
/// degrees to spare, as no one's neutral pose is exactly the model's.
BodyRig makeRig(const humanmodel::HumanModel& model);

/// Where all segments are.
struct RigPose {
  Transform X_WP{Transform::Identity()};       ///< of the pelvis
  std::array<Quaterniond, kRigSegments> R_PS;  ///< of balls: from the segment's axes into the parent's
  std::array<std::array<double, 2>, kRigSegments> angle{};  ///< of hinges, rad

  RigPose() { R_PS.fill(Quaterniond::Identity()); }
};

/// All segments in the world.
using RigPlacement = std::array<Transform, kRigSegments>;

/// Forward kinematics. No allocation, no throw.
void place(const BodyRig& rig, const RigPose& pose, RigPlacement& X_WS);

/// Where the canonical joints are, all of them with state `state`; `t` stays.
void jointsOf(const BodyRig& rig, const RigPlacement& X_WS, humanmodel::JointState state,
              humanmodel::SkeletonFrame& frame);

}  // namespace abstand::tracking
