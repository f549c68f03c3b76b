// How deep one mesh reaches into another, enclosed between two numbers.
#pragma once

#include "core/verify/brute_force.hpp"

namespace abstand::verify {

/// The deepest point of P's surface in the solid F lies between `least` and `most` below F's surface (m).
/// least is attained by a point of P's surface; negative when none was found inside.
struct Penetration {
  double least{-kInfinity};
  double most{-kInfinity};
};

/// Both in the same frame; F closed. The triangles of P are halved until the enclosure is narrower than
/// `tolerance` (m), or `max_samples` points were looked at: a triangle's points are no deeper than its
/// centre's depth plus its radius, as depth changes by no more than the way.
Penetration penetration(const TriangleSoup& P, const TriangleSoup& F, double tolerance, int max_samples);

}  // namespace abstand::verify
