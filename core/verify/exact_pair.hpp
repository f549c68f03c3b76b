// The true signed distance of two bodies, by brute force.
#pragma once

#include "core/verify/nasty_bodies.hpp"

namespace abstand::verify {

/// The true signed distance lies between the two (m). Apart: both are the distance of the meshes. Overlapping:
/// minus the greatest depth of the point body's surface in the field body, as far as it was enclosed. Where a
/// piece of the field body is swallowed whole by the point body, no point of the latter's surface is inside
/// anything; then the distance is some number that is not positive, as the solids overlap. Likewise where the
/// surfaces cut and the field body is open.
struct ExactDistance {
  double least;
  double most;
  bool overlapping;
};

/// P gives the points and F the field (pointsFromA in core/haptic/pair_query.hpp). Depths are enclosed to
/// `tolerance` (m) where some hundred samples reach that.
ExactDistance exactDistance(const NastyBody& P, const NastyBody& F, const Transform& X_FP, double tolerance);

}  // namespace abstand::verify
