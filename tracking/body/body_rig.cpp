// Divides the model into segments; forward kinematics.
#include "tracking/body/body_rig.hpp"

namespace abstand::tracking {
namespace {

using enum RigSegment;

constexpr std::array<std::string_view, kRigSegments> kNames{
    "pelvis",       "chest",         "head",       "upper_arm_left", "upper_arm_right",
    "forearm_left", "forearm_right", "hand_left",  "hand_right",     "thigh_left",
    "thigh_right",  "calf_left",     "calf_right", "foot_left",      "foot_right"};

// Bend of the trunk, as a share of the distance from the hip centre to the neck: the joint between the fourth
// and the fifth lumbar vertebra is at about 0.62 h, the hips are at 0.53 h, the neck at 0.82 h.
constexpr double kBendShare = 0.3;
// Factors of the visible trunk: its cross-section is an ellipse, not a box, and the model's box contains
// chest, waist and hips at their largest.
constexpr double kTrunkBreadth = 0.94, kTrunkDepth = 0.86;
// Overlap of the two trunk segments, so that no gap opens at the back when bending.
constexpr double kDrum = 1.15;

constexpr double kBack = unit::deg(40), kBackTwist = unit::deg(45);
constexpr double kNeckCone = unit::deg(65), kNeckTwist = unit::deg(85);
constexpr double kShoulderCone = unit::deg(130), kShoulderTwist = unit::deg(110);
constexpr double kHipCone = unit::deg(95), kHipTwist = unit::deg(60);
constexpr double kElbow = unit::deg(155), kKnee = unit::deg(155), kOverstretch = unit::deg(10);
constexpr double kWristFlexion = unit::deg(70), kWristDeviation = unit::deg(35);
constexpr double kAnkleDown = unit::deg(55), kAnkleUp = unit::deg(35), kAnkleRoll = unit::deg(30);

RigSegment onSide(RigSegment left, int side) { return side > 0 ? left : segmentAt(index(left) + 1); }
humanmodel::BodyPart onSide(humanmodel::BodyPart left, int side) {
  return static_cast<humanmodel::BodyPart>(humanmodel::index(left) + (side > 0 ? 0u : 1u));
}
humanmodel::Joint jointOf(const humanmodel::HumanModel& model, humanmodel::BodyPart part) {
  return model.part(part).proximal;
}

/// World position of a part's centre in the rest pose.
Vector3d centre(const humanmodel::HumanModel& model, humanmodel::BodyPart part) {
  const humanmodel::HumanPart& p = model.part(part);
  return model.rest[p.proximal] - p.p_proximal;
}

void addBall(RigPart& part, const Vector3d& along, const Vector3d& middle, double cone, double twist) {
  part.joint = RigJoint::kBall;
  part.freedoms = 3;
  part.along = along;
  part.middle = middle.normalized();
  part.cone = cone;
  part.twist = twist;
}

void addHinge(RigPart& part, int i, const Vector3d& axis, double lower, double upper) {
  part.joint = RigJoint::kHinges;
  part.freedoms = i + 1;
  part.axis[static_cast<std::size_t>(i)] = axis;
  part.lower[static_cast<std::size_t>(i)] = lower;
  part.upper[static_cast<std::size_t>(i)] = upper;
}

/// Builds a rig, segment by segment from the root outwards.
class RigBuilder {
 public:
  explicit RigBuilder(const humanmodel::HumanModel& model)
      : model_(model),
        rest_(model.rest),
        bend_(rest_[humanmodel::Joint::kPelvis] +
              kBendShare * (rest_[humanmodel::Joint::kNeck] - rest_[humanmodel::Joint::kPelvis])) {
    rig_.height = model.height;
  }

  BodyRig build() {
    addTrunk();
    for (const int side : {1, -1}) {
      addArm(side);
      addLeg(side);
      dressLimbs(side);
    }
    dressTrunk();
    int column = 0;
    for (RigPart& part : rig_.parts) {
      part.column = column;
      column += part.freedoms;
    }
    carryJoints();
    return rig_;
  }

 private:
  RigPart& hang(RigSegment s, RigSegment parent, const Vector3d& p_W) {
    p_WS_[index(s)] = p_W;
    RigPart& part = rig_.parts[index(s)];
    part.parent = parent;
    part.p_parent = p_W - p_WS_[index(parent)];
    return part;
  }
  /// At the proximal end of the part of the body.
  RigPart& hangPart(RigSegment s, RigSegment parent, humanmodel::BodyPart from) {
    return hang(s, parent, rest_[jointOf(model_, from)]);
  }
  void dress(RigSegment s, humanmodel::BodyPart from) {
    rig_.parts[index(s)].shape = model_.part(from).shape;
    rig_.parts[index(s)].p_shape = centre(model_, from) - p_WS_[index(s)];
  }
  void addTrunk() {
    const Vector3d z = Vector3d::UnitZ();
    RigPart& root = hang(kPelvis, kPelvis, rest_[humanmodel::Joint::kPelvis]);
    root.joint = RigJoint::kFree;
    root.freedoms = 6;
    root.p_parent.setZero();
    addBall(hang(kChest, kPelvis, bend_), z, z, kBack, kBackTwist);
    addBall(hang(kHead, kChest, rest_[humanmodel::Joint::kNeck]), z, z, kNeckCone, kNeckTwist);
    dress(kHead, humanmodel::BodyPart::kHead);
  }
  /// `side`: 1 left, -1 right.
  void addArm(int side) {
    const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
    const RigSegment upper = onSide(kUpperArmLeft, side), forearm = onSide(kForearmLeft, side);
    addBall(hangPart(upper, kChest, onSide(humanmodel::BodyPart::kBicepsLeft, side)), -z,
            x + 0.7 * side * y - 0.3 * z, kShoulderCone, kShoulderTwist);
    addHinge(hangPart(forearm, upper, onSide(humanmodel::BodyPart::kForearmLeft, side)), 0, -y, -kOverstretch,
             kElbow);
    RigPart& hand = hangPart(onSide(kHandLeft, side), forearm, onSide(humanmodel::BodyPart::kHandLeft, side));
    addHinge(hand, 0, x, -kWristFlexion, kWristFlexion);
    addHinge(hand, 1, y, -kWristDeviation, kWristDeviation);
  }
  void addLeg(int side) {
    const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
    const RigSegment thigh = onSide(kThighLeft, side), calf = onSide(kCalfLeft, side);
    addBall(hangPart(thigh, kPelvis, onSide(humanmodel::BodyPart::kThighLeft, side)), -z,
            x + 0.3 * side * y - 0.8 * z, kHipCone, kHipTwist);
    addHinge(hangPart(calf, thigh, onSide(humanmodel::BodyPart::kCalfLeft, side)), 0, y, -kOverstretch,
             kKnee);
    RigPart& foot = hangPart(onSide(kFootLeft, side), calf, onSide(humanmodel::BodyPart::kFootLeft, side));
    addHinge(foot, 0, y, -kAnkleUp, kAnkleDown);
    addHinge(foot, 1, x, -kAnkleRoll, kAnkleRoll);
  }
  void dressLimbs(int side) {
    dress(onSide(kUpperArmLeft, side), onSide(humanmodel::BodyPart::kBicepsLeft, side));
    dress(onSide(kForearmLeft, side), onSide(humanmodel::BodyPart::kForearmLeft, side));
    dress(onSide(kHandLeft, side), onSide(humanmodel::BodyPart::kHandLeft, side));
    dress(onSide(kThighLeft, side), onSide(humanmodel::BodyPart::kThighLeft, side));
    dress(onSide(kCalfLeft, side), onSide(humanmodel::BodyPart::kCalfLeft, side));
    dress(onSide(kFootLeft, side), onSide(humanmodel::BodyPart::kFootLeft, side));
  }
  /// Two ellipsoids in place of the model's one piece.
  void dressTrunk() {
    const humanmodel::HumanPart& torso = model_.part(humanmodel::BodyPart::kTorso);
    const Vector3d trunk = centre(model_, humanmodel::BodyPart::kTorso);
    const double top = trunk.z() + 0.5 * torso.length, bottom = trunk.z() - 0.5 * torso.length;
    const auto drum = [&](RigSegment s, double from, double to) {
      const Vector3d middle{trunk.x(), trunk.y(), 0.5 * (from + to)};
      rig_.parts[index(s)].shape = geometry::Ellipsoid{
          {0.5 * kTrunkDepth * torso.depth, 0.5 * kTrunkBreadth * torso.breadth, 0.5 * kDrum * (to - from)}};
      rig_.parts[index(s)].p_shape = middle - p_WS_[index(s)];
    };
    drum(kPelvis, bottom, bend_.z());
    drum(kChest, bend_.z(), top);
  }
  void carryJoints() {
    const auto carry = [&](humanmodel::Joint j, RigSegment s) {
      rig_.carrier[static_cast<std::size_t>(j)] = s;
      rig_.p_joint[static_cast<std::size_t>(j)] = rest_[j] - p_WS_[index(s)];
    };
    using enum humanmodel::Joint;
    for (const humanmodel::Joint j : {kPelvis, kHipLeft, kHipRight}) carry(j, RigSegment::kPelvis);
    for (const humanmodel::Joint j : {kSpine, kThorax, kNeck, kShoulderLeft, kShoulderRight})
      carry(j, kChest);
    for (const humanmodel::Joint j : {humanmodel::Joint::kHead, kHeadTop}) carry(j, RigSegment::kHead);
    carry(kElbowLeft, kUpperArmLeft);
    carry(kElbowRight, kUpperArmRight);
    carry(kWristLeft, kForearmLeft);
    carry(kWristRight, kForearmRight);
    carry(humanmodel::Joint::kHandLeft, RigSegment::kHandLeft);
    carry(humanmodel::Joint::kHandRight, RigSegment::kHandRight);
    carry(kKneeLeft, kThighLeft);
    carry(kKneeRight, kThighRight);
    carry(kAnkleLeft, kCalfLeft);
    carry(kAnkleRight, kCalfRight);
    carry(kToeLeft, kFootLeft);
    carry(kToeRight, kFootRight);
  }

  const humanmodel::HumanModel& model_;
  const humanmodel::SkeletonFrame& rest_;
  Vector3d bend_;  // where the trunk bends, rest pose
  BodyRig rig_;
  std::array<Vector3d, kRigSegments> p_WS_;  // origins in the rest pose
};

}  // namespace

std::string_view segmentName(RigSegment s) { return kNames[index(s)]; }

BodyRig makeRig(const humanmodel::HumanModel& model) { return RigBuilder(model).build(); }

void placeSegment(const BodyRig& rig, const RigPose& pose, RigSegment segment, RigPlacement& X_WS) {
  const std::size_t i = index(segment);
  const RigPart& part = rig.parts[i];
  Matrix3d R_PS;
  if (part.joint == RigJoint::kBall) {
    R_PS = pose.R_PS[i].toRotationMatrix();
  } else {
    R_PS = Eigen::AngleAxisd(pose.angle[i][0], part.axis[0]).toRotationMatrix();
    if (part.freedoms > 1) R_PS = R_PS * Eigen::AngleAxisd(pose.angle[i][1], part.axis[1]).toRotationMatrix();
  }
  const Transform& X_WP = X_WS[index(part.parent)];
  X_WS[i].linear() = X_WP.linear() * R_PS;
  X_WS[i].translation() = X_WP * part.p_parent;
}

void place(const BodyRig& rig, const RigPose& pose, RigPlacement& X_WS) {
  X_WS[0] = pose.X_WP;
  for (std::size_t i = 1; i < kRigSegments; ++i) placeSegment(rig, pose, segmentAt(i), X_WS);
}

Vector3d jointPosition(const BodyRig& rig, const RigPlacement& X_WS, humanmodel::Joint joint) {
  const auto j = static_cast<std::size_t>(joint);
  return X_WS[index(rig.carrier[j])] * rig.p_joint[j];
}

void jointsOf(const BodyRig& rig, const RigPlacement& X_WS, humanmodel::JointState state,
              humanmodel::SkeletonFrame& frame) {
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    const auto joint = static_cast<humanmodel::Joint>(j);
    frame.set(joint, jointPosition(rig, X_WS, joint), state);
  }
}

}  // namespace abstand::tracking
