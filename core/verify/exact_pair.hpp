// The true signed distance of two bodies, by brute force.
#pragma once

#include "core/verify/nasty_bodies.hpp"

namespace abstand::verify {

/// The true signed distance lies between the two (m). Apart: both are the distance of the meshes.
/// Overlapping: minus the greatest depth of the point body's surface in the field body, as far as it was
/// enclosed; minus infinity to 0 where surfaces meet and the field body is open. A piece of the field body
/// that the point body swallows whole has no part of the latter's surface inside it: then it is the distance
/// of the surfaces, as core/haptic/pair_query.hpp has it, though the solids overlap.
struct ExactDistance {
  double least;
  double most;
  bool overlapping;
  bool swallowed;
};

/// P gives the points and F the field (pointsFromA in core/haptic/pair_query.hpp). Depths are enclosed to
/// `tolerance` (m) where some hundred samples reach that.
ExactDistance exactDistance(const NastyBody& P, const NastyBody& F, const Transform& X_FP, double tolerance);

}  // namespace abstand::verify
