// Quantiles of measured values.
#pragma once

#include <vector>

namespace abstand {

// n values have an exact quantile at n shares only. Between them there are three conventions, and results,
// tests and published figures depend on each. All three return one of the values, never an average of two,
// and NaN for no values. `share`: 0 to 1.

/// Smallest value v such that at least this share of the values is <= v: the value number ceil(share n),
/// counted from 1. Never underestimates, so error figures use it.
double lowerQuantile(std::vector<double> values, double share);

/// Smallest value v such that more than this share of the values is <= v: the value number floor(share n) +
/// 1; the largest for share 1.
double upperQuantile(std::vector<double> values, double share);

/// The sorted value whose index is nearest to share (n - 1), counted from 0; the upper one of two equally
/// near. Symmetric except for that tie, so estimates from recordings use it.
double nearestQuantile(std::vector<double> values, double share);

}  // namespace abstand
