// Statistics of values.
#pragma once

#include <vector>

namespace abstand::verify {

/// Root mean square; NaN for no values.
double rms(const std::vector<double>& values);

/// Least-squares slope of log y over log x: the order of convergence, for errors y at steps x. All values are
/// positive; at least two.
double logSlope(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace abstand::verify
