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

SafeMargin smallestSafeMargin(const ClearanceTrack& track, const MarginOptions& options);

/// The first frame from which on a margin can be judged: before it the recording begins with the person so
/// near, or so unknown, that the robot could not have stopped in time whatever the margin. frames() where
/// there is none.
std::size_t firstJudgedFrame(const ClearanceTrack& track, const MarginOptions& options);

/// The frames from `first` on.
ClearanceTrack from(const ClearanceTrack& track, std::size_t first);

}  // namespace abstand::margin
