// Lists of a recording's frames, from memory or from its result file.
#pragma once

#include <optional>

#include "app/tune/recording_tune.hpp"
#include "app/tune/result_file.hpp"

namespace abstand::tune {

/// The parts of a recording with the lists of their frames, which are read from its result file if there is
/// one: all parts of one of many recordings are in memory. Valid while the recording is. Any thread.
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

/// The same part after part: of a recording that is not in memory only the frames of one part are. Valid
/// while the recording is. One thread.
class PartByPart {
 public:
  /// Throws as PartFrames, as does part().
  explicit PartByPart(const TunedRecording& recording);

  std::size_t size() const { return recording_.pass.parts.size(); }
  /// Valid until the next call.
  const PartClearance& part(std::size_t p);

 private:
  const TunedRecording& recording_;
  std::optional<FrameReader> file_;  ///< none: the frames are in memory
  PartClearance read_;
};

/// Frame-wise minimum over all parts.
struct WholeBody {
  margin::ClearanceTrack track;
  /// Frame from which every part can be judged (margin::firstJudgedFrame); the number of frames if there is
  /// none.
  std::size_t first{0};

  /// Adds a part. Throws UsageError for one with other times.
  void take(const margin::ClearanceTrack& part, const margin::MarginOptions& options);
};
/// Throws as PartFrames.
WholeBody wholeBody(const TunedRecording& recording, const margin::MarginOptions& options);

/// Decides which of many recordings, whose frames are in result files too, keep them in memory: the first
/// ones. Memory then does not grow with the number of recordings.
class HeldFrames {
 public:
  /// Frames of single parts, of about 150 bytes each.
  static constexpr std::size_t kUsual = 700'000;

  explicit HeldFrames(std::size_t max = kUsual) : max_(max) {}
  /// Frames of single parts that may still be held.
  std::size_t left() const { return max_ - std::min(max_, held_); }
  /// Empties the lists of the recording if the frames so far are more than the maximum.
  void take(TunedRecording& recording);

 private:
  std::size_t max_, held_{0};
};

}  // namespace abstand::tune
