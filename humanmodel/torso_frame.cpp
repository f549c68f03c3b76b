// Torso orientation from hips, shoulders, neck and spine.
#include "humanmodel/torso_frame.hpp"

#include <algorithm>

#include "humanmodel/segment_frame.hpp"

namespace abstand::humanmodel {
namespace {

using enum Joint;

// Hip and shoulder lines that nearly cancel, or are parallel to the spine, do not determine the twist.
constexpr double kWeakLine = 0.1;

/// A recorded point and the corresponding joint of the model.
struct Landmark {
  Vector3d p_W;
  Joint joint;
  JointState quality;
};

JointState worse(JointState a, JointState b) { return std::min(a, b); }
JointState qualityOf(const SkeletonFrame& frame, Joint j) { return frame.state[static_cast<std::size_t>(j)]; }

std::optional<Landmark> upperEnd(const SkeletonFrame& frame) {
  for (const Joint j : {kNeck, kThorax})
    if (frame.has(j)) return Landmark{frame[j], j, qualityOf(frame, j)};
  if (frame.has(kShoulderLeft) && frame.has(kShoulderRight))
    return Landmark{0.5 * (frame[kShoulderLeft] + frame[kShoulderRight]), kThorax,
                    worse(qualityOf(frame, kShoulderLeft), qualityOf(frame, kShoulderRight))};
  if (frame.has(kSpine)) return Landmark{frame[kSpine], kSpine, qualityOf(frame, kSpine)};
  return std::nullopt;
}

JointState hipQuality(const SkeletonFrame& frame) {
  if (frame.has(kHipLeft) && frame.has(kHipRight))
    return worse(qualityOf(frame, kHipLeft), qualityOf(frame, kHipRight));
  return qualityOf(frame, kPelvis);
}

/// Sum of the unit hip and shoulder lines, right to left; zero if both are missing.
Vector3d lateralLine(const SkeletonFrame& frame) {
  Vector3d sum = Vector3d::Zero();
  for (const auto& [right, left] : {std::pair{kHipRight, kHipLeft}, std::pair{kShoulderRight, kShoulderLeft}})
    if (frame.has(right) && frame.has(left))
      if (const auto line = directionFrom(frame[right], frame[left])) sum += *line;
  return sum;
}

}  // namespace

std::optional<Vector3d> hipCentre(const SkeletonFrame& frame) {
  if (frame.has(kHipLeft) && frame.has(kHipRight)) return 0.5 * (frame[kHipLeft] + frame[kHipRight]);
  if (frame.has(kPelvis)) return frame[kPelvis];
  return std::nullopt;
}

std::optional<TorsoView> viewTorso(const SkeletonFrame& frame, const HumanModel& model,
                                   const std::optional<Matrix3d>& R_last) {
  const std::optional<Vector3d> hips = hipCentre(frame);
  const std::optional<Landmark> upper = upperEnd(frame);
  if (!upper) return std::nullopt;
  const HumanPart& torso = model.part(BodyPart::kTorso);

  // Reference point and up direction.
  TorsoView view;
  std::optional<Vector3d> up;
  if (hips) {
    up = directionFrom(*hips, upper->p_W);
    view.p_WA = *hips;
    view.p_PA = torso.p_distal;
    view.quality = worse(upper->quality, hipQuality(frame));
  } else {
    if (frame.has(kSpine)) up = directionFrom(frame[kSpine], upper->p_W);
    if (!up) up = R_last ? Vector3d(R_last->col(2)) : Vector3d::UnitZ();
    view.on_hips = false;
    view.p_WA = upper->p_W;
    view.p_PA = torso.p_distal + model.rest[upper->joint] - model.rest[kPelvis];
    view.quality = JointState::kInferred;
  }
  if (!up) return std::nullopt;

  // Rotation about that direction.
  Vector3d y = lateralLine(frame);
  if (y.cross(*up).norm() < kWeakLine) {
    if (!R_last) return std::nullopt;
    y = carriedY(*R_last, Vector3d::UnitZ(), *up);
    view.quality = JointState::kInferred;
  }
  view.R_WP = frameAlong(Vector3d::UnitZ(), *up, y);
  return view;
}

}  // namespace abstand::humanmodel
