// Poses one frame: placing, holding and ageing of the parts.
#include "humanmodel/poser.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "humanmodel/joint_covariance.hpp"
#include "humanmodel/recording_lengths.hpp"

namespace abstand::humanmodel {
namespace {

// m; larger coordinates are invalid.
constexpr double kFarthest = 1e6;
// A recording whose leg ratio is outside of this range does not determine the height above the floor.
constexpr double kSmallestRatio = 0.5, kLargestRatio = 2.0;

bool usable(const SkeletonFrame& frame) {
  if (!std::isfinite(frame.t)) return false;
  for (std::size_t j = 0; j < kJointCount; ++j) {
    if (frame.state[j] == JointState::kMissing) continue;
    if (!frame.p[j].allFinite() || frame.p[j].cwiseAbs().maxCoeff() > kFarthest) return false;
  }
  return true;
}

/// The joint that connects a part to its parent.
Joint innerJoint(const HumanPart& part) { return part.part == BodyPart::kHead ? part.distal : part.proximal; }

/// By how much a point on the surface of a part moves along the bone if the joints at both ends move one unit
/// across it, in opposite directions: the part turns by 2 / length, the point is at most half its breadth off
/// the bone.
double turnShare(const HumanPart& part) {
  return std::min(1.0, std::max(part.breadth, part.depth) / part.length);
}

/// The covariance with standard deviations of at least `share` times the largest, along all axes.
Matrix3d withTurn(const Matrix3d& covariance, double share) {
  if (!covariance.allFinite()) return covariance;
  const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(covariance);
  const double least = share * share * axes.eigenvalues()[2];
  const Vector3d widened = axes.eigenvalues().array().max(least);
  return axes.eigenvectors() * widened.asDiagonal() * axes.eigenvectors().transpose();
}

const Vector3d& innerPoint(const HumanPart& part) {
  return part.part == BodyPart::kHead ? part.p_distal : part.p_proximal;
}

}  // namespace

Poser::Poser(const HumanModel& model, bool follow_lengths, double floor)
    : model_{&model}, follow_lengths_{follow_lengths}, floor_{floor} {
  p_joint_on_parent_.fill(Vector3d::Zero());
  for (const auto& [parent, child] : adjacentParts()) {
    // In the rest pose every part has the world's axes.
    const HumanPart& carrier = model.part(parent);
    const Vector3d p_WP = model.rest[carrier.proximal] - carrier.p_proximal;
    p_joint_on_parent_[index(child)] = model.rest[innerJoint(model.part(child))] - p_WP;
  }
  reset();
}

void Poser::reset() {
  before_ = now_ = HumanPose{};
  last_t_ = kNaN;
  lift_ = 0.0;
  if (!calibrated_) leg_ratio_ = 1.0;
}

void Poser::calibrate(std::span<const SkeletonFrame> recording) {
  const std::optional<double> ratio = legRatio(*model_, recording);
  if (!ratio) return;
  leg_ratio_ = std::clamp(*ratio, kSmallestRatio, kLargestRatio);
  calibrated_ = true;
  if (const auto ankle = standingAnkle(recording, floor_)) {
    recorded_ankle_ = *ankle;
    model_ankle_ = model_->rest[Joint::kAnkleLeft].z();
  }
}

void Poser::pose(const SkeletonFrame& frame, HumanPose& out) {
  const double dt = std::isfinite(frame.t) && std::isfinite(last_t_) ? std::max(0.0, frame.t - last_t_) : 0.0;
  if (std::isfinite(frame.t)) last_t_ = frame.t;
  const bool good = usable(frame);

  before_ = now_;
  now_.state.fill(PartState::kNone);
  for (std::size_t i = 0; i < kBodyPartCount; ++i) {
    const auto part = static_cast<BodyPart>(i);
    if (const MaybeAim seen = good ? aim(part, frame) : std::nullopt) {
      now_.X_WP[i].linear() = seen->R_WP;
      now_.X_WP[i].translation() = seen->p_WA - seen->R_WP * seen->p_PA;
      now_.state[i] = seen->quality == JointState::kTracked ? PartState::kTracked : PartState::kInferred;
      now_.age[i] = 0.0;
      stateError(part, frame);
    } else if (before_.state[i] != PartState::kNone) {
      if (good) now_.X_WP[i] = held(part);
      now_.state[i] = PartState::kHeld;
      now_.age[i] = before_.age[i] + dt;
      now_.spread[i] = before_.spread[i];
      now_.covariance[i] = Matrix3d::Zero();
    }
  }
  out = now_;
}

Poser::MaybeAim Poser::aim(BodyPart part, const SkeletonFrame& frame) {
  if (part == BodyPart::kTorso) return aimTorso(frame);
  MaybeAim aimed;
  switch (kindOf(part)) {
    case PartKind::kHead:
      aimed = aimHead(frame);
      break;
    case PartKind::kBiceps:
    case PartKind::kThigh:
      aimed = aimUpperLimb(part, frame);
      break;
    case PartKind::kForearm:
    case PartKind::kCalf:
      aimed = aimLowerLimb(part, frame);
      break;
    case PartKind::kHand:
      aimed = aimHand(part, frame);
      break;
    default:
      aimed = aimFoot(part, frame);
      break;
  }
  if (aimed && !anchor(part, frame, *aimed)) return std::nullopt;
  return aimed;
}

bool Poser::anchor(BodyPart part, const SkeletonFrame& frame, Aim& aim) const {
  const HumanPart& p = model_->part(part);
  const Joint inner = innerJoint(p);
  const PartKind kind = kindOf(part);
  const bool limb = kind == PartKind::kBiceps || kind == PartKind::kForearm || kind == PartKind::kThigh ||
                    kind == PartKind::kCalf;
  const bool on_parent = seenNow(*parentOf(part));
  aim.p_PA = innerPoint(p);
  if (follow_lengths_ && limb) {
    // The error of a different bone length is split between both ends.
    aim.p_PA = 0.5 * (p.p_proximal + p.p_distal);
    aim.p_WA = 0.5 * (frame[p.proximal] + frame[p.distal]);
  } else if (on_parent && !(follow_lengths_ && frame.has(inner))) {
    aim.p_WA = now_.X_WP[index(*parentOf(part))] * p_joint_on_parent_[index(part)];
  } else if (frame.has(inner)) {
    // The carrying part is stale, or joints are placed as recorded.
    aim.p_WA = frame[inner] + lift_ * Vector3d::UnitZ();
  } else {
    return false;
  }
  return true;
}

void Poser::stateError(BodyPart part, const SkeletonFrame& frame) {
  const HumanPart& p = model_->part(part);
  const std::size_t i = index(part);
  double spread = 0.0;
  Matrix3d covariance = Matrix3d::Zero();
  bool is_shaped = false;
  const auto add = [&](const Joint j) {
    if (!frame.has(j)) return;
    spread = std::max(spread, frame.spread[static_cast<std::size_t>(j)]);
    covariance = enclosingCovariance(covariance, covarianceOf(frame, j));
    is_shaped |= !frame.covariance[static_cast<std::size_t>(j)].isZero(0.0);
  };
  for (const Joint j : {p.proximal, p.distal}) add(j);
  if (part == BodyPart::kTorso)
    for (const Joint j : {Joint::kHipLeft, Joint::kHipRight, Joint::kShoulderLeft, Joint::kShoulderRight})
      add(j);
  // Legs depend on the hips, even if the upper end of the trunk is known.
  const auto parent = parentOf(part);
  if (kindOf(part) == PartKind::kThigh) {
    for (const Joint j : {Joint::kHipLeft, Joint::kHipRight, Joint::kPelvis}) add(j);
  } else if (parent) {
    const std::size_t carrier = index(*parent);
    spread = std::max(spread, now_.spread[carrier]);
    const bool of_carrier = !now_.covariance[carrier].isZero(0.0);
    const double squared = now_.spread[carrier] * now_.spread[carrier];
    covariance =
        enclosingCovariance(covariance, of_carrier ? now_.covariance[carrier]
                                                   : Matrix3d(Vector3d::Constant(squared).asDiagonal()));
    is_shaped |= of_carrier;
  }
  now_.spread[i] = spread;
  now_.covariance[i] = is_shaped ? withTurn(covariance, turnShare(p)) : Matrix3d::Zero();
}

bool Poser::seenNow(BodyPart part) const { return now_.state[index(part)] >= PartState::kInferred; }

Matrix3d Poser::carried(BodyPart part) const {
  const std::size_t self = index(part), parent = index(*parentOf(part));
  const bool self_known = before_.state[self] != PartState::kNone;
  if (now_.state[parent] == PartState::kNone)
    return self_known ? Matrix3d(before_.X_WP[self].linear()) : Matrix3d(Matrix3d::Identity());
  if (!self_known) return now_.X_WP[parent].linear();
  if (before_.state[parent] == PartState::kNone) return before_.X_WP[self].linear();
  return now_.X_WP[parent].linear() * before_.X_WP[parent].linear().transpose() * before_.X_WP[self].linear();
}

Transform Poser::held(BodyPart part) const {
  const std::size_t self = index(part);
  const std::optional<BodyPart> carrier = parentOf(part);
  if (!carrier) return before_.X_WP[self];
  const std::size_t parent = index(*carrier);
  // A carrier that is held may still have moved with its own carrier.
  if (before_.state[parent] == PartState::kNone || now_.state[parent] == PartState::kNone)
    return before_.X_WP[self];
  Transform X = now_.X_WP[parent] * before_.X_WP[parent].inverse() * before_.X_WP[self];
  // Prevents drift by products of rotations; a part may be held for hours.
  X.linear() = Quaterniond(X.linear()).normalized().toRotationMatrix();
  return X;
}

double Poser::liftOf(double hip_height, const SkeletonFrame& frame) {
  if (follow_lengths_) return 0.0;
  if (!calibrated_)
    if (const auto ratio = legRatio(*model_, frame))
      leg_ratio_ = std::clamp(*ratio, kSmallestRatio, kLargestRatio);
  const double recorded = hip_height - floor_;
  return model_ankle_ + leg_ratio_ * (recorded - recorded_ankle_) - recorded;
}

}  // namespace abstand::humanmodel
