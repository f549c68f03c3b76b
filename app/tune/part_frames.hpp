// Lists of a recording's frames, from memory or from its result file.
#pragma once

#include "app/tune/recording_tune.hpp"

namespace abstand::tune {

/// The parts of a recording with the lists of their frames, which are read from its result file if there is
/// one, so that only one of many recordings is in memory. Valid while the recording is. Any thread.
class PartFrames {
 public:
  /// Throws ParseError for a result file that is damaged or was replaced since.
  explicit PartFrames(const TunedRecording& recording);

  const std::vector<PartClearance>& parts() const { return *parts_; }
  /// s, of each frame.
  const std::vector<double>& times() const { return parts_->front().track.t; }

 private:
  std::shared_ptr<const std::vector<PartClearance>> parts_;
};

/// First frame from which every part can be judged (margin::firstJudgedFrame); the number of frames if there
/// is none.
std::size_t firstJudgedFrame(const PartFrames& frames, const margin::MarginOptions& options);

}  // namespace abstand::tune
