// Distances of pairs against exact distances of meshes, over poses that are hard on the engine.
#pragma once

#include "core/haptic/haptic_options.hpp"
#include "core/verify/check.hpp"

namespace abstand::verify {

/// Asks queryPair about options.poses nasty poses with one kind of field.
/// - bound.FIELD: (distance - true distance) / bound, which the contract keeps below 1: the true distance is
///   never below distance - bound.
/// - attained.FIELD: how far the distance lies below the true one, which it may not, as it is the distance of
///   two points of the surfaces (or the depth of one).
/// Both tables have one row a family of poses, with the errors in voxels.
std::vector<CheckResult> checkCertifiedBound(FieldKind field, const VerifyOptions& options);

}  // namespace abstand::verify
