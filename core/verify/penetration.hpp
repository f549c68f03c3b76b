// Enclosure of the penetration depth of one mesh in another.
#pragma once

#include "core/verify/brute_force.hpp"

namespace abstand::verify {

/// The deepest point of P's surface in the solid F is between `lower` and `upper` below F's surface (m).
/// `lower` is attained by a point of P's surface; negative if none was found inside.
struct Penetration {
  double lower{-kInfinity};
  double upper{-kInfinity};
};

/// Both in the same frame; F closed. Bisects the triangles of P until the enclosure is narrower than
/// `tolerance` (m) or `max_samples` points were evaluated: a triangle's points are at most as deep as its
/// centre's depth plus its radius, as depth is 1-Lipschitz.
Penetration penetration(const TriangleSoup& P, const TriangleSoup& F, double tolerance, int max_samples);

}  // namespace abstand::verify
