// The true signed distance of two bodies, by brute force.
#pragma once

#include "core/verify/adversarial_bodies.hpp"

namespace abstand::verify {

/// The true signed distance lies between the two (m). Apart: both are the distance of the meshes.
/// Overlapping: minus the greatest depth of either body's surface in the other, as far as it was enclosed;
/// minus infinity to the distance of the meshes where a body is open. `swallowed`: a piece of the field body
/// lies whole in the point body, where none of the latter's points sees it.
struct ExactDistance {
  double least;
  double most;
  bool overlapping;
  bool swallowed;
};

/// P gives the points and F the field (pointsFromA in core/query/pair_query.hpp). Depths are enclosed to
/// `tolerance` (m) where some hundred samples reach that.
ExactDistance exactDistance(const AdversarialBody& P, const AdversarialBody& F, const Transform& X_FP,
                            double tolerance);

}  // namespace abstand::verify
