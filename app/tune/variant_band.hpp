// One recording as several people, places and speeds: what that changes.
#pragma once

#include <string>
#include <vector>

#include "app/tune/recording_tune.hpp"

namespace abstand::tune {

/// The smallest and the largest value of some runs.
struct Band {
  double least{kInfinity}, largest{-kInfinity};
  std::size_t of_least{0}, of_largest{0};  ///< indices of the runs

  void take(double value, std::size_t run);
};

/// Runs of a study that are the same recording: with people of other statures and percentiles, mirrored,
/// moved, or at another speed.
struct VariantBand {
  std::string part;
  std::vector<std::size_t> runs;  ///< indices of the recordings
  Band margin;                    ///< m, smallest safe margin; infinite where none would do
  Band clearance;                 ///< m, least certified clearance
};

/// Of each part of each recording that has more than one run; recordings are the same where their content is.
std::vector<VariantBand> variantBands(const std::vector<TunedRecording>& recordings,
                                      const margin::MarginOptions& options);

}  // namespace abstand::tune
