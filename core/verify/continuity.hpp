// How smoothly forces follow small steps.
#pragma once

#include "core/verify/check.hpp"

namespace abstand::verify {

/// The largest jump of the force over paths in steps of a tenth of a voxel. One result a path: for float and
/// mixed fields, jump over the jump that is possible for a continuous field, stiffness times pressed area
/// times sqrt(3) times step (a trilinear field of distances changes by at most sqrt(3) of the way). Layers
/// change by whole voxels; they stand in the table and the plot for comparison.
std::vector<CheckResult> checkContinuity(const VerifyOptions& options);

}  // namespace abstand::verify
