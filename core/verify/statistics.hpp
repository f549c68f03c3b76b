// Figures of many numbers.
#pragma once

#include <vector>

namespace abstand::verify {

/// Root of the mean square; NaN of none.
double rms(const std::vector<double>& values);

/// Slope of log y over log x by least squares: the order of convergence, for errors y at steps x.
/// All values are positive and there are at least two.
double logSlope(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace abstand::verify
