// Tests motion prediction and speed bounds on a recording.
#pragma once

#include <span>
#include <vector>

#include "core/safety/reach_set.hpp"
#include "tracking/recording/recording.hpp"

namespace abstand::tracking {

/// Results over all joints and frames with a position `ahead` s later, between two frames with positions.
struct PredictionTrial {
  double ahead{0.0};  ///< s
  std::size_t places{0};
  double still_mean{0.0}, still_p95{0.0};                  ///< m, error of assuming no motion
  double guess_mean{0.0}, guess_p95{0.0}, guess_max{0.0};  ///< m, error of the prediction
  std::size_t outside{0};    ///< positions outside of the reachable set of the bounds
  double speed_needed{0.0};  ///< m/s: smallest speed bound that would have contained all of them
};

/// Predictions of MotionPrediction with its default weights; reachable sets of reachAt() from the position
/// and the predicted velocity. Joints that were not measured (inferred, missing) are ignored. Throws
/// UsageError for invalid bounds.
std::vector<PredictionTrial> tryPredictions(const Recording& recording, const safety::MotionBounds& bounds,
                                            std::span<const double> ahead);

}  // namespace abstand::tracking
