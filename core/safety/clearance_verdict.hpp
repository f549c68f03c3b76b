// Whether a pair keeps a required clearance: one rule for window, gate and reports.
#pragma once

#include <cstdint>

namespace abstand::safety {

/// What is known of the distance of a pair, in m.
struct KnownDistance {
  double distance;     ///< measured; negative: penetration; NaN: not known
  double bound;        ///< the true distance of the two shapes is at least `distance` - `bound`
  double uncertainty;  ///< pose uncertainty of both bodies, at least 0; infinite: one was not seen at all
};

/// m: distance - bound - uncertainty, below which the bodies certainly are not nearer; -infinity where
/// something is not known.
double certifiedClearance(const KnownDistance& known);

enum class ClearanceVerdict : std::uint8_t {
  kKept,       ///< certified
  kNotProven,  ///< the measured distance keeps it, but may be wrong by more than what is left
  kBroken,     ///< the measured distance breaks it, or is not known
};

/// Whether distance and bound keep `required` (m) widened by the pose uncertainty.
ClearanceVerdict verdict(const KnownDistance& known, double required);

}  // namespace abstand::safety
