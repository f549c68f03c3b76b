// Whether a pair keeps a required clearance: one rule for window, `check` and reports.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/math/transform.hpp"

namespace abstand::safety {

/// Known distance of a pair, in m.
struct KnownDistance {
  double distance;     ///< measured; negative: penetration; NaN: unknown
  double bound;        ///< the true distance of the two shapes is at least `distance` - `bound`
  double uncertainty;  ///< pose uncertainty of both bodies, >= 0; infinite: a body was not seen at all
};

/// Certified clearance distance - bound - uncertainty (m), a lower bound of the true distance; -infinity if
/// unknown.
inline double certifiedClearance(const KnownDistance& known) {
  const double clearance = known.distance - known.bound - known.uncertainty;
  return std::isnan(clearance) ? -kInfinity : clearance;
}

/// It is not certain that two surfaces are apart where their poses put them: `distance` (m) is within its
/// `bound` (m), or negative. False for NaN. The rule that tells a contact from what is only inside a margin.
inline bool isTouching(double distance, double bound) { return distance <= std::max(0.0, bound); }

enum class ClearanceVerdict : std::uint8_t {
  kKept,       ///< certified
  kNotProven,  ///< the measured distance keeps it, but the uncertainty does not allow to certify it
  kBroken,     ///< the measured distance violates it, or is unknown
};

/// Whether distance and bound keep `required` (m) plus the pose uncertainty.
ClearanceVerdict verdict(const KnownDistance& known, double required);

}  // namespace abstand::safety
