// How far ahead a person can be guessed, and whether bounds on people's speed hold: tried on a recording.
#pragma once

#include <span>
#include <vector>

#include "core/safety/reach_set.hpp"
#include "tracking/recording/recording.hpp"

namespace abstand::tracking {

/// Of all joints at all frames that have a place `ahead` s later, between two frames that have one.
struct PredictionTrial {
  double ahead{0.0};  ///< s
  std::size_t places{0};
  double still_mean{0.0}, still_p95{0.0};                   ///< m, from where the joint was
  double guess_mean{0.0}, guess_p95{0.0}, guess_most{0.0};  ///< m, from where it was guessed
  std::size_t outside{0};    ///< places that a reach set of the bounds does not hold
  double speed_needed{0.0};  ///< m/s: the least bound on the speed that would have held all of them
};

/// Guesses are those of MotionPrediction with its usual weights, reach sets those of reachAt() from the place
/// and the guessed velocity. Joints that were not measured (inferred, missing) do not count. Throws
/// UsageError for bounds that are not allowed.
std::vector<PredictionTrial> tryPredictions(const Recording& recording, const safety::MotionBounds& bounds,
                                            std::span<const double> ahead);

}  // namespace abstand::tracking
