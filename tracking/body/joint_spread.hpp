// Uncertainty of joint positions from a fit.
#pragma once

#include "tracking/body/body_solver.hpp"

namespace abstand::tracking {

using JointCovariances = std::array<Matrix3d, humanmodel::kJointCount>;

/// Covariance (m^2, world axes) of each canonical joint: J S J^T, with S the inverse of `information` (of the
/// problem's dof, rows weighted by their inverse variance) and J the joint's Jacobian. Infinite on the
/// diagonal if undetermined. No allocation, no throw.
JointCovariances jointCovariances(const BodyRig& rig, const BodySolver& problem,
                                  const BodySolver::Matrix& information);
/// Standard deviation (m) of each joint along the worst axis of that covariance. Infinite if undetermined.
std::array<double, humanmodel::kJointCount> jointSpreads(const BodyRig& rig, const BodySolver& problem,
                                                         const BodySolver::Matrix& information);

}  // namespace abstand::tracking
