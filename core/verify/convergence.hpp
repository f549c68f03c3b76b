// How fast forces become right with finer voxels and points.
#pragma once

#include "core/verify/check.hpp"

namespace abstand::verify {

/// The relative error of the force (root of the mean square over random poses), against closed forms, over
/// five resolutions, voxel = point spacing = h. Two scenes, a ball pressed into a ball and a ball pressed
/// into a wall, and three fields: each gives a result whose number is minus the order of convergence (the
/// slope on log-log paper by least squares), so that limits are -1 for layers and -2 for float distances.
/// Layers against a ball have no result of their own, as they do not converge there; the plot shows them.
std::vector<CheckResult> checkConvergence(const VerifyOptions& options);

}  // namespace abstand::verify
