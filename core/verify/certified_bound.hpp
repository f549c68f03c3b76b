// Distances of pairs against exact distances of meshes, over poses that are hard on the engine.
#pragma once

#include "core/verify/check.hpp"

namespace abstand::verify {

/// Asks queryPair about options.poses adversarial poses, with each kind of field. Two results a field:
/// - bound.FIELD: (distance - true distance) / bound, which the contract keeps at or below 1: the true
/// distance
///   is never below distance - bound. The table has one row a family of poses, with the errors in voxels.
/// - attained.FIELD: how far the distance lies below the true one, which it may not, as it is the distance of
///   two points of the surfaces (or the depth of one).
std::vector<CheckResult> checkCertifiedBound(const VerifyOptions& options);

}  // namespace abstand::verify
