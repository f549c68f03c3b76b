// Poses of two bodies that are difficult for a sampling engine.
#pragma once

#include "core/math/random.hpp"
#include "core/verify/adversarial_bodies.hpp"

namespace abstand::verify {

enum class PoseFamily {
  kRandom,     ///< random relative pose
  kEdges,      ///< edge on edge
  kTips,       ///< a corner over a face, between its samples
  kEdgeFace,   ///< an edge along a face
  kFaces,      ///< coplanar faces
  kIdentical,  ///< the same pose, up to rounding
  kNested,     ///< one centre near the other's
  kGrid,       ///< rotated by right angles, moved by half voxels
  kFar,        ///< metres to a kilometre apart
};
inline constexpr int kPoseFamilies = 9;
const char* familyName(PoseFamily family);

/// Two bodies and their poses. The gap of families in contact is 0, a nanometre, or a share of a voxel, of
/// either sign.
struct AdversarialPose {
  std::size_t a, b;
  PoseFamily family;
  Transform X_WA, X_WB;
};

/// Pose `index` of the infinite sequence of `seed`.
AdversarialPose adversarialPose(const std::vector<AdversarialBody>& bodies, std::uint64_t seed,
                                std::uint64_t index);

}  // namespace abstand::verify
