// Smallest margin without a missed stop.
#pragma once

#include <optional>

#include "core/margin/margin_outcome.hpp"

namespace abstand::margin {

/// Exact, without search: a stop at frame b is commanded by exactly the margins in (clearance[b], clearance[b
/// - 1]]. If it is too late (braking[b] at or below the limit), all of these miss; so margins above the
/// largest such clearance[b - 1] miss no stop.
struct SafeMargin {
  /// m: every larger margin misses no stop; 0 if even a margin of 0 misses none; infinite if the robot could
  /// not have stopped in time from the first frame on.
  double margin{0.0};
  std::size_t frame{0};  ///< the frame b that determines it; only if `decided`
  bool decided{false};   ///< a stop would have been too late with a smaller margin
  /// m, part of `margin`: decrease of the clearance in the one frame before the stop command, or after the
  /// last frame outside. The largest gain of a higher frame rate.
  double sampling{0.0};
};

/// Finds the smallest safe margin frame by frame, without storing frames. Skips frames before the first one
/// from which a margin can be judged (firstJudgedFrame). One thread.
class SafeMarginWatch {
 public:
  /// `from_start`: no frame is skipped.
  explicit SafeMarginWatch(const MarginOptions& options, bool from_start = false)
      : options_(options), judged_(from_start) {}

  /// Values (m) of ClearanceTrack at the next frame.
  void add(double clearance, double between, double braking);
  /// Its frame counts from the first add().
  const SafeMargin& value() const { return safe_; }
  bool judged() const { return judged_; }

 private:
  void need(double margin, double sampling);

  MarginOptions options_;
  SafeMargin safe_;
  std::size_t frames_{0};
  bool judged_;
  double before_{kInfinity};  ///< m, clearance of the previous frame
};

/// Smallest safe margin of the whole track, from its first frame on.
SafeMargin smallestSafeMargin(const ClearanceTrack& track, const MarginOptions& options);

/// The first frame from which a margin can be judged: before it the person is so near, or so uncertain, at
/// the start of the recording that the robot could not have stopped in time with any margin. frames() if
/// there is none.
std::size_t firstJudgedFrame(const ClearanceTrack& track, const MarginOptions& options);

/// m, rounded up to whole millimetres and above `needed`, as a margin must be.
double roundedUpMargin(double needed);

/// The frames from `first` on.
ClearanceTrack from(const ClearanceTrack& track, std::size_t first);

}  // namespace abstand::margin
