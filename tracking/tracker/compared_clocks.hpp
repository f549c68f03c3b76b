// Clocks of several depth recordings of the same people.
#pragma once

#include <span>
#include <vector>

#include "tracking/tracker/clip_tracker.hpp"
#include "tracking/tracker/clock_offset.hpp"

namespace abstand::tracking {

struct ComparedClocks {
  std::vector<ClockOffset> offsets;  ///< of each stream but the first, against the first
  double seconds{0.0};               ///< s of processor time, without reading images
};

/// Tracks the people of each stream separately, in one pass through the first kCompared seconds (LoneCamera).
/// The two people of a stream and of the first one whose joints agree best are taken for the same; which way
/// each faces, and so what is left and right, may be wrong in one of them. Needs camera poses in one world.
/// Of `options`, person, known and interrupted are used. Throws ParseError.
ComparedClocks compareClocks(std::span<DepthStream* const> streams, const ClipTrackerOptions& options);

inline constexpr double kCompared = 20.0;  ///< s of each stream

}  // namespace abstand::tracking
