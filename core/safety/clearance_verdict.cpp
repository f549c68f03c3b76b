#include "core/safety/clearance_verdict.hpp"

namespace abstand::safety {

ClearanceVerdict verdict(const KnownDistance& known, double required) {
  const double widened = required + known.uncertainty;
  // The negated form treats NaN as broken.
  if (!(known.distance >= widened) || !(known.uncertainty < kInfinity)) return ClearanceVerdict::kBroken;
  return known.distance - known.bound >= widened ? ClearanceVerdict::kKept : ClearanceVerdict::kNotProven;
}

}  // namespace abstand::safety
