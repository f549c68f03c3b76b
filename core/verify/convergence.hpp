// Check of the convergence order of forces with resolution.
#pragma once

#include "core/verify/check.hpp"

namespace abstand::verify {

/// Relative force error (RMS over random poses) against closed forms, over five resolutions, voxel = point
/// spacing = h. Two scenes, a ball pressed into a ball and a ball pressed into a wall, and three fields; each
/// result is minus the order of convergence (least-squares slope in log-log scale), so limits are -1 for
/// layers and -2 for float distances. Layers against a ball have no result, as they do not converge there;
/// the plot shows them.
std::vector<CheckResult> checkConvergence(const VerifyOptions& options);

}  // namespace abstand::verify
