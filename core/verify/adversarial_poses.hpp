// Poses of two bodies that are hard on an engine which samples.
#pragma once

#include "core/math/random.hpp"
#include "core/verify/adversarial_bodies.hpp"

namespace abstand::verify {

enum class PoseFamily {
  kRandom,     ///< anywhere about each other
  kEdges,      ///< edge on edge
  kTips,       ///< a corner over a face, between its samples
  kEdgeFace,   ///< an edge along a face
  kFaces,      ///< coplanar faces
  kIdentical,  ///< the same pose, to rounding
  kNested,     ///< one centre near the other's
  kGrid,       ///< turned by right angles, moved by half voxels
  kFar,        ///< metres to a kilometre apart
};
inline constexpr int kPoseFamilies = 9;
const char* familyName(PoseFamily family);

/// Two bodies and where they are; the gap of the families that touch is 0, a nanometre, or some part of a
/// voxel, of either sign.
struct AdversarialPose {
  std::size_t a, b;
  PoseFamily family;
  Transform X_WA, X_WB;
};

/// Number `index` of the endless list that `seed` names.
AdversarialPose adversarialPose(const std::vector<AdversarialBody>& bodies, std::uint64_t seed,
                                std::uint64_t index);

}  // namespace abstand::verify
