// Position and orientation of the torso of a skeleton.
#pragma once

#include <optional>

#include "humanmodel/human_model.hpp"

namespace abstand::humanmodel {

/// The torso in a frame.
struct TorsoView {
  Matrix3d R_WP;
  Vector3d p_WA;       ///< recorded reference point A of the torso
  Vector3d p_PA;       ///< the same point in the model's torso
  bool on_hips{true};  ///< A is the hip centre (or the pelvis), not the shoulders
  JointState quality{JointState::kTracked};
};

/// Midpoint of the hip joints, or the pelvis if one of them is missing.
std::optional<Vector3d> hipCentre(const SkeletonFrame& frame);

/// z runs from the hip centre to the neck, otherwise to the thorax, the midpoint of the shoulders or the
/// spine; y is the mean of the hip line and the shoulder line. Without hips and pelvis (a person behind a
/// table) the torso is placed by its upper end, along the spine joint if there is one, otherwise upright as
/// `R_last` or as the world. Without both lines the twist is carried on from `R_last`. nullopt if the trunk
/// cannot be placed.
std::optional<TorsoView> viewTorso(const SkeletonFrame& frame, const HumanModel& model,
                                   const std::optional<Matrix3d>& R_last);

}  // namespace abstand::humanmodel
