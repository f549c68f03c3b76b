// True signed distance of two bodies, by brute force.
#pragma once

#include "core/verify/adversarial_bodies.hpp"

namespace abstand::verify {

/// Enclosure of the true signed distance (m). Separated: both are the distance of the meshes. Overlapping:
/// minus the greatest depth of either body's surface in the other, as far as it was enclosed; minus infinity
/// to the distance of the meshes if a body is open. `swallowed`: a component of the field body lies
/// completely inside the point body, where none of the latter's points detects it.
struct ExactDistance {
  double lower;
  double upper;
  bool overlapping;
  bool swallowed;
};

/// P gives the points and F the field (pointsFromA in core/query/pair_query.hpp). Depths are enclosed within
/// `tolerance` (m) if some hundred samples suffice.
ExactDistance exactDistance(const AdversarialBody& P, const AdversarialBody& F, const Transform& X_FP,
                            double tolerance);

}  // namespace abstand::verify
