// Predicted contacts over all recordings of an answer.
#pragma once

#include "app/tune/recording_tune.hpp"

namespace abstand::tune {

/// One part: how long a contact would have exceeded a limit, and its hardest one.
struct ContactRow {
  std::string part;
  double exceeded{0.0};                     ///< s, over all recordings
  const TunedRecording* worst_in{nullptr};  ///< null: nothing near ever closed in
  const ContactMoment* worst{nullptr};      ///< of `worst_in`
};

ContactRow contactRow(const std::vector<TunedRecording>& recordings, const std::string& part);

}  // namespace abstand::tune
