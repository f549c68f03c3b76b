// Quantiles of measured values.
#pragma once

#include <vector>

namespace abstand {

// n values have an exact quantile at n shares only; between them there are three customs, and results, tests
// and published figures rest on each of them. All give one of the values, never a mean of two; NaN of none.
// `share`: 0 to 1.

/// The smallest value that at least this share of the values do not exceed: number ceil(share n), counted
/// from 1. Never below what it speaks for, so figures of errors use it.
double lowerQuantile(std::vector<double> values, double share);

/// The smallest value that more than this share of the values do not exceed: number floor(share n) + 1; the
/// largest for 1.
double upperQuantile(std::vector<double> values, double share);

/// The value whose place is nearest to share (n - 1), counted from 0, of two equally near ones the upper. The
/// same from either end but for that, so estimates from recordings use it.
double nearestQuantile(std::vector<double> values, double share);

}  // namespace abstand
