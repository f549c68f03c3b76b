// Check of the continuity of forces under small steps.
#pragma once

#include "core/verify/check.hpp"

namespace abstand::verify {

/// Largest jump of the force over paths in steps of a tenth of a voxel. One result for each path: for float
/// and mixed fields, the jump relative to that of a continuous field, stiffness times pressed area times
/// sqrt(3) times step (a trilinear distance field changes by at most sqrt(3) times the displacement). Layers
/// change by whole voxels; they are in the table and the plot for comparison.
std::vector<CheckResult> checkContinuity(const VerifyOptions& options);

}  // namespace abstand::verify
