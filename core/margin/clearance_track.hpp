// Clearance of a person's parts and a robot over one recording.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::margin {

/// Frames of one recording. Clearances are certified: distance - bound - pose uncertainty (m), a lower bound
/// of the true distance; -infinity if a body was not seen at all. All lists have one entry for each frame.
struct ClearanceTrack {
  std::vector<double> t;          ///< s, increasing
  std::vector<double> clearance;  ///< m, at the frame
  /// m: certified minimum from frame i to frame i + 1, both bodies moving as recorded; +infinity in the last
  /// frame.
  std::vector<double> between;
  /// m: certified minimum from frame i until the robot is at rest, if a stop is commanded at frame i and the
  /// person moves on as recorded; +infinity if the robot does not move.
  std::vector<double> braking;

  std::size_t frames() const { return t.size(); }
  double duration() const { return t.empty() ? 0.0 : t.back() - t.front(); }
};

/// Throws UsageError for lists of different lengths, times that do not increase, and NaN.
void validate(const ClearanceTrack& track);

/// Replaces the values of `least` by those of `track` where these are smaller. Throws UsageError for
/// different times.
void takeLeast(const ClearanceTrack& track, ClearanceTrack& least);

/// Frame-wise minimum of several tracks of one recording. Throws UsageError for no tracks and for tracks with
/// different times.
ClearanceTrack leastOf(std::span<const ClearanceTrack* const> tracks);

}  // namespace abstand::margin
