#include "tracking/recording/stated_twist.hpp"

#include <cmath>
#include <optional>

#include "core/math/quantile.hpp"
#include "humanmodel/poser.hpp"
#include "tracking/recording/derived_joints.hpp"
#include "tracking/recording/up_axis.hpp"

namespace abstand::tracking {
namespace {

using humanmodel::BodyPart;
using humanmodel::HumanPose;
using humanmodel::index;
using humanmodel::SkeletonFrame;

constexpr double kUpright = 0.8;    // cosine, of trunk, head and legs in a rest pose
constexpr double kStraight = 0.75;  // cosine, of an elbow in a rest pose
constexpr double kForward = 0.5;    // cosine, of feet in a rest pose
constexpr double kBent = 0.34;      // sine of 20 degrees: a hinge that determines the twist
// rad: a rest pose with the palms ahead or up instead of down differs by a right angle; and the median of the
// distance from the mean, of a hinge that turns with the arm.
constexpr double kDeviates = unit::deg(60.0), kSteadyHinge = unit::deg(40.0);
constexpr std::size_t kPartsOfArm = 3;  // in kTurnedParts

bool isArm(BodyPart part) { return part > BodyPart::kHead && part < BodyPart::kThighLeft; }

/// The upper arm of an arm, which determines whether its orientations are used.
BodyPart upperArmOf(BodyPart part) {
  while (humanmodel::kindOf(part) != humanmodel::PartKind::kBiceps) part = *humanmodel::parentOf(part);
  return part;
}

bool isKnown(const HumanPose& pose, BodyPart part) {
  return pose.state[index(part)] >= humanmodel::PartState::kInferred;
}
Vector3d axis(const HumanPose& pose, BodyPart part, int column) {
  return pose.X_WP[index(part)].linear().col(column);
}

/// Whether the rest pose shows the twist of a part: that of somebody who stands.
bool showsTwist(const HumanPose& rest, BodyPart part) {
  if (!isKnown(rest, BodyPart::kTorso) || !isKnown(rest, part)) return false;
  if (axis(rest, BodyPart::kTorso, 2).z() < kUpright) return false;
  if (part == BodyPart::kHead) return axis(rest, part, 2).z() > kUpright;
  if (isArm(part)) {
    const BodyPart upper = upperArmOf(part), fore = static_cast<BodyPart>(index(upper) + 2);
    return isKnown(rest, upper) && isKnown(rest, fore) &&
           axis(rest, upper, 2).dot(axis(rest, fore, 2)) > kStraight;
  }
  const BodyPart calf = *humanmodel::parentOf(part);
  return isKnown(rest, calf) && axis(rest, calf, 2).z() > kUpright &&
         axis(rest, part, 0).dot(axis(rest, BodyPart::kTorso, 0)) > kForward;
}

/// y axis (world) of a part, as its neighbours show it; nullopt: they do not.
std::optional<Vector3d> shownY(const HumanPose& pose, BodyPart part) {
  const auto hinge = [&](BodyPart of) { return isKnown(pose, of) ? axis(pose, of, 2) : Vector3d::Zero(); };
  if (!isKnown(pose, part)) return std::nullopt;
  if (part == BodyPart::kHead) return axis(pose, BodyPart::kTorso, 1);
  if (isArm(part)) {
    // As Poser::aimUpperLimb.
    const Vector3d y = hinge(static_cast<BodyPart>(index(part) + 2)).cross(hinge(part));
    if (y.norm() < kBent) return std::nullopt;
    return y.normalized();
  }
  return axis(pose, part, 1);
}

class Twists {
 public:
  Twists(const StatedTurns& turns, const Matrix3d& R_WF, const std::vector<SkeletonFrame>& frames)
      : turns_{turns}, R_WF_{R_WF} {
    SkeletonFrame rest = turns.rest;
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) rest.p[j] = R_WF * rest.p[j];
    rest.t = 0.0;
    humanmodel::Poser(model_).pose(rest, rest_);
    for (std::size_t k = 0; k < kTurnedParts.size(); ++k) y_rest_[k] = axis(rest_, kTurnedParts[k].part, 1);
    humanmodel::Poser poser(model_);
    for (const std::size_t i : sampleIndices(frames.size()))
      poser.pose(frames[i], sampled_.emplace_back(i, HumanPose{}).second);
  }
  bool isUsable(std::size_t k) const {
    return turns_.source[k] >= 0 && showsTwist(rest_, kTurnedParts[k].part);
  }
  Vector3d y(std::size_t k, std::size_t frame) const {
    const Matrix3d R = turns_.frames[frame][k].cast<double>().toRotationMatrix();
    return R_WF_ * (R * (R_WF_.transpose() * y_rest_[k]));
  }
  /// Angle (rad) about the bone from the stated to the shown y axis, in each sampled frame that shows it.
  std::vector<double> deviations(std::size_t k) const {
    std::vector<double> angles;
    for (const auto& [i, pose] : sampled_) {
      const BodyPart part = kTurnedParts[k].part;
      const std::optional<Vector3d> shown = shownY(pose, part);
      if (!shown) continue;
      const Vector3d z = axis(pose, part, 2), stated = y(k, i);
      angles.push_back(
          std::atan2(z.dot(stated.cross(*shown)), stated.dot(*shown) - stated.dot(z) * shown->dot(z)));
    }
    return angles;
  }
  /// Turns the y axis of a part at rest about its bone (rad).
  void turnRest(std::size_t k, double angle) {
    y_rest_[k] = Eigen::AngleAxisd(angle, axis(rest_, kTurnedParts[k].part, 2)) * y_rest_[k];
  }

 private:
  const StatedTurns& turns_;
  Matrix3d R_WF_;
  humanmodel::HumanModel model_ = humanmodel::makeHuman({});
  HumanPose rest_;
  std::array<Vector3d, kTurnedParts.size()> y_rest_;
  std::vector<std::pair<std::size_t, HumanPose>>
      sampled_;  ///< frames by their index, before any twist is set
};

struct Deviation {
  double mean{0.0}, spread{0.0};  ///< rad; median of the distance from the mean
};

Deviation deviationOf(std::vector<double> angles) {
  if (angles.empty()) return {};
  double sine = 0.0, cosine = 0.0;
  for (const double a : angles) sine += std::sin(a), cosine += std::cos(a);
  const double mean = std::atan2(sine, cosine);
  for (double& a : angles) a = std::abs(std::remainder(a - mean, 2.0 * kPi));
  return {mean, nearestQuantile(std::move(angles), 0.5)};
}

}  // namespace

StatedTwist stateTwist(const StatedTurns& turns, const Matrix3d& R_WF, std::vector<SkeletonFrame>& frames) {
  StatedTwist result;
  if (turns.frames.size() != frames.size()) return result;
  Twists twists(turns, R_WF, frames);
  std::array<bool, kTurnedParts.size()> is_used{};
  for (std::size_t k = 0; k < kTurnedParts.size(); ++k) {
    const BodyPart part = kTurnedParts[k].part;
    if (!twists.isUsable(k)) continue;
    const bool of_arm = isArm(part), is_first = !of_arm || part == upperArmOf(part);
    if (!is_first) {
      // Forearm and hand turn on the upper arm, of which a bent elbow shows the twist.
      is_used[k] = is_used[k - 1];
    } else {
      const Deviation deviation = deviationOf(twists.deviations(k));
      const bool deviates = std::abs(deviation.mean) > kDeviates;
      is_used[k] = deviation.spread < kSteadyHinge && (of_arm || !deviates);
      if (is_used[k] && deviates)
        for (std::size_t of = k; of < k + kPartsOfArm; ++of) twists.turnRest(of, deviation.mean);
    }
    if (is_used[k])
      result.parts.emplace_back(humanmodel::partName(part));
    else if (is_first)
      result.notes.push_back("the orientations of " + std::string(humanmodel::partName(part)) +
                             " in the file contradict the positions of its joints: its twist" +
                             (of_arm ? ", and those of forearm and hand, follow" : " follows") +
                             " from these");
  }
  for (std::size_t i = 0; i < frames.size(); ++i)
    for (std::size_t k = 0; k < kTurnedParts.size(); ++k)
      if (is_used[k])
        frames[i].lateral[static_cast<std::size_t>(kTurnedParts[k].end)] = twists.y(k, i).cast<float>();
  return result;
}

}  // namespace abstand::tracking
