// Protective distances over all recordings of an answer.
#pragma once

#include "app/tune/recording_tune.hpp"

namespace abstand::tune {

/// One part: how long its protective distance was broken, and its worst moment.
struct SeparationRow {
  std::string part;
  double broken{0.0};                       ///< s, over all recordings
  const TunedRecording* worst_in{nullptr};  ///< null: kept everywhere
  const SeparationMoment* worst{nullptr};   ///< of `worst_in`
};

SeparationRow separationRow(const std::vector<TunedRecording>& recordings, const std::string& part);

/// The term of S_p that would have to shrink most: the largest one. "person", "reaction", "stopping",
/// "constant".
const char* largestTerm(const safety::ProtectiveDistance& needed);

}  // namespace abstand::tune
