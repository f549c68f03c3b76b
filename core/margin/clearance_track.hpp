// How near something of a person came to a robot over one recording.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::margin {

/// The frames of one recording. A clearance is certified: distance - bound - pose uncertainty (m), so the
/// true distance is never below it; -infinity where a body was not seen at all. All lists have one entry a
/// frame.
struct ClearanceTrack {
  std::vector<double> t;          ///< s, rising
  std::vector<double> clearance;  ///< m, at the frame
  /// m: certified least distance from frame i to frame i + 1, both bodies in step with the recording;
  /// +infinity in the last frame, behind which nothing is known.
  std::vector<double> between;
  /// m: certified least distance from frame i until the robot is at rest, when it is told to stop at frame i
  /// and the person goes on as recorded; +infinity where the robot does not move.
  std::vector<double> braking;

  std::size_t frames() const { return t.size(); }
  double duration() const { return t.empty() ? 0.0 : t.back() - t.front(); }
};

/// Throws UsageError for lists of different lengths, times that do not rise and NaN.
void validate(const ClearanceTrack& track);

/// Frame by frame the least of several tracks of one recording. Throws UsageError for none and for tracks
/// with other times.
ClearanceTrack leastOf(std::span<const ClearanceTrack* const> tracks);

}  // namespace abstand::margin
