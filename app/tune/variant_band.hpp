// Range of results over variants of one recording: people, places and speeds.
#pragma once

#include <string>
#include <vector>

#include "app/tune/recording_tune.hpp"

namespace abstand::tune {

/// Smallest and largest value over some runs.
struct Band {
  double least{kInfinity}, largest{-kInfinity};
  std::size_t of_smallest{0}, of_largest{0};  ///< indices of the runs

  void take(double value, std::size_t run);
};

/// Runs of a study with the same recording: other statures and percentiles, mirrored, moved, or at another
/// speed.
struct VariantBand {
  std::string part;
  std::vector<std::size_t> runs;  ///< indices of the recordings
  Band margin;                    ///< m, smallest safe margin; infinite if none suffices
  Band clearance;                 ///< m, smallest certified clearance
};

/// For each part of each recording with several runs; recordings are equal if their content is.
std::vector<VariantBand> variantBands(const std::vector<TunedRecording>& recordings,
                                      const margin::MarginOptions& options);

}  // namespace abstand::tune
