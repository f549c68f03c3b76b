// Uncertainty of joint positions from a fit.
#pragma once

#include "tracking/body/body_solver.hpp"

namespace abstand::tracking {

/// Standard deviation (m) of each canonical joint along its worst axis: of J S J^T, with S the inverse of
/// `information` (of the problem's dof, rows weighted by their inverse variance) and J the joint's Jacobian.
/// Infinite if undetermined. No allocation, no throw.
std::array<double, humanmodel::kJointCount> jointSpreads(const BodyRig& rig, const BodySolver& problem,
                                                         const BodySolver::Matrix& information);

}  // namespace abstand::tracking
