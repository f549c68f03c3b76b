// Standard normal distribution function and its inverse.
#pragma once

namespace abstand::humanmodel {

/// Share (0 to 1) of a normal distribution below `score` standard deviations from its mean.
double normalShare(double score);

/// Inverse of normalShare. `share` in the open interval (0, 1).
double normalScore(double share);

}  // namespace abstand::humanmodel
