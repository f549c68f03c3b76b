#include "core/safety/clearance_verdict.hpp"

#include <cmath>

#include "core/math/transform.hpp"

namespace abstand::safety {

double certifiedClearance(const KnownDistance& known) {
  const double clearance = known.distance - known.bound - known.uncertainty;
  return std::isnan(clearance) ? -kInfinity : clearance;
}

ClearanceVerdict verdict(const KnownDistance& known, double required) {
  const double widened = required + known.uncertainty;
  // The negated form treats NaN as broken.
  if (!(known.distance >= widened) || !(known.uncertainty < kInfinity)) return ClearanceVerdict::kBroken;
  return known.distance - known.bound >= widened ? ClearanceVerdict::kKept : ClearanceVerdict::kNotProven;
}

}  // namespace abstand::safety
