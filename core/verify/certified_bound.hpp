// Check of certified distances against exact ones, in adversarial poses.
#pragma once

#include "core/verify/check.hpp"

namespace abstand::verify {

/// Runs queryPair() on options.poses adversarial poses, with each kind of field. Two results for each field:
/// - bound.FIELD: (distance - true distance) / bound, at most 1 by contract: the true distance is never below
///   distance - bound. The table has one row for each family of poses, with the errors in voxels.
/// - attained.FIELD: by how much the distance is below the true one; must be 0, as it is the distance of two
///   points of the surfaces (or the depth of one).
std::vector<CheckResult> checkCertifiedBound(const VerifyOptions& options);

}  // namespace abstand::verify
