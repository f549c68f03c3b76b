// The torso of a skeleton: where it is and how it is turned.
#pragma once

#include <optional>

#include "humanmodel/human_model.hpp"

namespace abstand::humanmodel {

/// The torso as a frame shows it.
struct TorsoView {
  Matrix3d R_WP;
  Vector3d p_WA;       ///< the recorded point A that the torso is hung on
  Vector3d p_PA;       ///< the same point in the model's torso
  bool on_hips{true};  ///< A is the middle of the hips (or the pelvis), not the shoulders
  JointState quality{JointState::kTracked};
};

/// The middle of the hip joints, or the pelvis where one of them is missing.
std::optional<Vector3d> hipCentre(const SkeletonFrame& frame);

/// z runs from the hip centre to the neck, else the thorax, the middle of the shoulders or the spine; y is
/// the mean of the hip line and the shoulder line. Without any hip or pelvis (a person behind a table) the
/// torso hangs on its upper end, along the spine joint if there is one, else upright as `R_last` was or as
/// the world is. Without both lines the twist is carried on from `R_last`. Nothing when the trunk cannot be
/// placed.
std::optional<TorsoView> viewTorso(const SkeletonFrame& frame, const HumanModel& model,
                                   const std::optional<Matrix3d>& R_last);

}  // namespace abstand::humanmodel
