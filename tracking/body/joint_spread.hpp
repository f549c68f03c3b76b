// How well a fit knows where the joints are.
#pragma once

#include "tracking/body/body_solver.hpp"

namespace abstand::tracking {

/// Standard deviation (m) of each canonical joint along its worst axis: of J S J^T, S the inverse of
/// `information` (that of the problem's freedoms, rows weighted by their inverse variance) and J how the
/// joint moves with them. Infinite where the problem says nothing. No allocation, no throw.
std::array<double, humanmodel::kJointCount> jointSpreads(const BodyRig& rig, const BodySolver& problem,
                                                         const BodySolver::Matrix& information);

}  // namespace abstand::tracking
