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

/// Decides which of many recordings, whose frames are in result files too, keep them in memory: the first
/// ones. Memory then does not grow with the number of recordings.
class HeldFrames {
 public:
  /// Frames of single parts, of about 140 bytes each.
  static constexpr std::size_t kUsual = 2'000'000;

  explicit HeldFrames(std::size_t max = kUsual) : max_(max) {}
  /// Empties the lists of the recording if the frames so far are more than the maximum.
  void take(TunedRecording& recording);

 private:
  std::size_t max_, held_{0};
};

/// First frame from which every part can be judged (margin::firstJudgedFrame); the number of frames if there
/// is none.
std::size_t firstJudgedFrame(const PartFrames& frames, const margin::MarginOptions& options);

}  // namespace abstand::tune
