// The smallest margin that would have missed no stop.
#pragma once

#include <optional>

#include "core/margin/margin_outcome.hpp"

namespace abstand::margin {

/// Exact, not searched: a stop at frame b is told by the margins in (clearance[b], clearance[b - 1]] and by
/// no other. Where it comes too late (braking[b] at or below the limit), all of these miss; so the margins
/// above the largest such clearance[b - 1] miss nothing.
struct SafeMargin {
  /// m: every margin above it misses no stop; 0 where even none would have missed one; infinite where the
  /// robot could not have stopped in time from the first frame on.
  double margin{0.0};
  std::size_t frame{0};  ///< the frame b that decides it; only with `decided`
  bool decided{false};   ///< some stop would have come too late with a smaller margin
  /// m, of `margin`: by how much the clearance fell in the one frame before the stop was told, or behind the
  /// last frame outside. A camera that looks more often needs so much less at most.
  double sampling{0.0};
};

/// Finds the smallest safe margin frame by frame and keeps no frame. Frames before the first one from which a
/// margin can be judged (firstJudgedFrame) are passed over. One thread.
class SafeMarginWatch {
 public:
  /// `from_start`: no frame is passed over.
  explicit SafeMarginWatch(const MarginOptions& options, bool from_start = false)
      : options_(options), judged_(from_start) {}

  /// m: the values of ClearanceTrack at the next frame.
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
  double before_{kInfinity};  ///< m, clearance one frame before
};

/// Of the whole track, from its first frame on.
SafeMargin smallestSafeMargin(const ClearanceTrack& track, const MarginOptions& options);

/// The first frame from which on a margin can be judged: before it the recording begins with the person so
/// near, or so unknown, that the robot could not have stopped in time whatever the margin. frames() where
/// there is none.
std::size_t firstJudgedFrame(const ClearanceTrack& track, const MarginOptions& options);

/// The frames from `first` on.
ClearanceTrack from(const ClearanceTrack& track, std::size_t first);

}  // namespace abstand::margin
