// The standard normal distribution: from a score to a share and back.
#pragma once

namespace abstand::humanmodel {

/// Share (0 to 1) of a normal distribution below `score` standard deviations from its mean.
double normalShare(double score);

/// The score below which a share lies: the inverse of normalShare. `share` between 0 and 1, both excluded.
double normalScore(double share);

}  // namespace abstand::humanmodel
