// Orientation of each kind of part: bone from the joints, twist from bends and neighbours.
#include <algorithm>

#include "humanmodel/poser.hpp"
#include "humanmodel/segment_frame.hpp"
#include "humanmodel/torso_frame.hpp"

namespace abstand::humanmodel {
namespace {

using enum Joint;
const Vector3d kZ = Vector3d::UnitZ();

// A hinge axis nearly parallel to the bone does not determine the twist.
constexpr double kWeakHinge = 0.1;
// Sine of the angle to the bone: likewise of a stated axis, which is perpendicular to the bone at rest.
constexpr double kWeakTwist = 0.2;

/// The next part on the same limb.
BodyPart nextOnLimb(BodyPart part) { return static_cast<BodyPart>(index(part) + 2); }

/// Elbows bend the forearm forwards, knees bend the calf backwards.
bool isArm(BodyPart part) { return part < BodyPart::kThighLeft; }

JointState worst(const SkeletonFrame& frame, std::initializer_list<Joint> joints) {
  JointState state = JointState::kTracked;
  for (const Joint j : joints) state = std::min(state, frame.state[static_cast<std::size_t>(j)]);
  return state;
}

/// y axis (world) that the frame states for the part that ends at `joint`, whose bone is along `z` (world).
std::optional<Vector3d> statedY(const SkeletonFrame& frame, Joint joint, const Vector3d& z) {
  const Vector3d y = frame.lateral[static_cast<std::size_t>(joint)].cast<double>();
  if (!y.allFinite() || y.cross(z).norm() < kWeakTwist) return std::nullopt;
  return (y - y.dot(z) * z).normalized();
}

std::optional<Vector3d> direction(const SkeletonFrame& frame, Joint from, Joint to) {
  if (!frame.has(from) || !frame.has(to)) return std::nullopt;
  return directionFrom(frame[from], frame[to]);
}

}  // namespace

Poser::MaybeAim Poser::aimTorso(const SkeletonFrame& frame) {
  std::optional<Matrix3d> R_last;
  if (before_.state[index(BodyPart::kTorso)] != PartState::kNone)
    R_last = before_.X_WP[index(BodyPart::kTorso)].linear();
  const std::optional<TorsoView> view = viewTorso(frame, *model_, R_last);
  if (!view) return std::nullopt;
  // Without hips the height above the floor is unknown; the last lift is kept.
  if (view->on_hips) lift_ = liftOf(view->p_WA.z(), frame);
  return Aim{view->R_WP, view->quality, view->p_WA + lift_ * kZ, view->p_PA};
}

Poser::MaybeAim Poser::aimHead(const SkeletonFrame& frame) const {
  const bool on_torso = seenNow(BodyPart::kTorso);
  const Matrix3d R =
      on_torso ? Matrix3d(now_.X_WP[index(BodyPart::kTorso)].linear()) : carried(BodyPart::kHead);
  const Joint end = frame.has(kHeadTop) ? kHeadTop : kHead;
  // The head's bone starts at the neck, or at the thorax if no neck was recorded.
  const Joint base = frame.has(kNeck) ? kNeck : kThorax;
  if (const auto z = direction(frame, base, end)) {
    const Vector3d y = statedY(frame, kHeadTop, *z).value_or(carriedY(R, kZ, *z));
    return Aim{frameAlong(kZ, *z, y), worst(frame, {base, end})};
  }
  if (!on_torso) return std::nullopt;
  return Aim{R, JointState::kInferred};
}

Poser::MaybeAim Poser::aimUpperLimb(BodyPart part, const SkeletonFrame& frame) const {
  const HumanPart& bone = model_->part(part);
  const auto z = direction(frame, bone.distal, bone.proximal);
  if (!z) return std::nullopt;
  const std::optional<Vector3d> stated = statedY(frame, bone.distal, *z);
  Vector3d y = stated ? *stated : carriedY(carried(part), kZ, *z);
  // The hinge of elbow or knee, unless the limb is straight.
  const HumanPart& next = model_->part(nextOnLimb(part));
  if (const auto onward = direction(frame, next.proximal, next.distal)) {
    const Vector3d hinge = isArm(part) ? onward->cross(-*z) : (-*z).cross(*onward);
    y = turnedToHinge(y, *z, hinge, stated || before_.state[index(part)] != PartState::kNone);
  }
  return Aim{frameAlong(kZ, *z, y), worst(frame, {bone.proximal, bone.distal})};
}

Poser::MaybeAim Poser::aimLowerLimb(BodyPart part, const SkeletonFrame& frame) const {
  const HumanPart& bone = model_->part(part);
  const auto z = direction(frame, bone.distal, bone.proximal);
  if (!z) return std::nullopt;
  const BodyPart upper = *parentOf(part);
  Vector3d y = now_.X_WP[index(upper)].linear().col(1);
  if (!seenNow(upper) || y.cross(*z).norm() < kWeakHinge) y = carriedY(carried(part), kZ, *z);
  // A forearm turns about its bone, a calf hardly.
  if (isArm(part)) y = statedY(frame, bone.distal, *z).value_or(y);
  return Aim{frameAlong(kZ, *z, y), worst(frame, {bone.proximal, bone.distal})};
}

Poser::MaybeAim Poser::aimHand(BodyPart part, const SkeletonFrame& frame) const {
  const HumanPart& bone = model_->part(part);
  const BodyPart forearm = *parentOf(part);
  const Matrix3d R = seenNow(forearm) ? Matrix3d(now_.X_WP[index(forearm)].linear()) : carried(part);
  if (const auto z = direction(frame, bone.distal, bone.proximal)) {
    const Vector3d y = statedY(frame, bone.distal, *z).value_or(carriedY(R, kZ, *z));
    return Aim{frameAlong(kZ, *z, y), worst(frame, {bone.proximal, bone.distal})};
  }
  if (!seenNow(forearm)) return std::nullopt;
  return Aim{R, JointState::kInferred};
}

Poser::MaybeAim Poser::aimFoot(BodyPart part, const SkeletonFrame& frame) const {
  const HumanPart& bone = model_->part(part);
  const std::size_t calf = index(*parentOf(part)), torso = index(BodyPart::kTorso);
  const bool on_calf = seenNow(*parentOf(part));
  const Vector3d z_calf = now_.X_WP[calf].linear().col(2);

  if (const auto toes = direction(frame, bone.proximal, bone.distal)) {
    const Vector3d a_P = (bone.p_distal - bone.p_proximal).normalized();
    const std::optional<Vector3d> stated = statedY(frame, bone.distal, *toes);
    Vector3d y = stated ? *stated : carriedY(carried(part), a_P, *toes);
    if (on_calf && !stated)
      y = turnedToHinge(y, *toes, z_calf.cross(*toes), before_.state[index(part)] != PartState::kNone);
    return Aim{frameAlong(a_P, *toes, y), worst(frame, {bone.proximal, bone.distal})};
  }
  // Without a toe the foot is at a right angle to the calf, forward of the body.
  if (!on_calf) return std::nullopt;
  if (now_.state[torso] == PartState::kNone) return Aim{now_.X_WP[calf].linear(), JointState::kInferred};
  const Vector3d y = carriedY(now_.X_WP[torso].linear(), kZ, z_calf);
  return Aim{frameAlong(kZ, z_calf, y), JointState::kInferred};
}

}  // namespace abstand::humanmodel
