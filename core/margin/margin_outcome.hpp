// Outcome of a safety margin over a recording.
#pragma once

#include <optional>

#include "core/margin/clearance_track.hpp"

namespace abstand::margin {

struct MarginOptions {
  /// m: margins shall prevent a clearance at or below this while the robot moves; 0: contact.
  double limit{0.0};
  double restart_time{0.0};  ///< s, from the end of an intrusion until the robot moves again
};

/// Throws UsageError.
void validate(const MarginOptions& options);

/// A stretch of frames with a clearance below the margin. A stop is commanded at `begin`.
struct Intrusion {
  std::size_t begin{0}, end{0};     ///< first frame inside, first frame outside again (or number of frames)
  double min_clearance{0.0};        ///< m, minimum at and between the frames, if the robot had not stopped
  double braking{0.0};              ///< m, ClearanceTrack::braking at `begin`
  bool false_stop{false};           ///< the limit would certainly have been kept without a stop
  bool missed{false};               ///< the limit is not certainly kept until the robot is at rest
  std::optional<double> lead_time;  ///< s, from `begin` to the first clearance at the limit, without a stop
};

/// Counts over one or more recordings. Missed and false stops are decided on certified clearances: unknown
/// counts as missed, and not as a false stop.
struct MarginOutcome {
  long stops{0}, false_stops{0}, missed_stops{0};
  /// Frames outside of the margin before whose next frame the limit was reached: no stop was commanded.
  /// Included in missed_stops.
  long unseen{0};
  double stopped_time{0.0}, time{0.0};  ///< s
  double min_clearance{kInfinity};      ///< m, certified, while the robot moved, with the stops
  std::optional<double> lead_time;      ///< s, shortest

  double stoppedShare() const { return time > 0.0 ? stopped_time / time : 0.0; }
  void add(const MarginOutcome& other);
};

/// Intrusions into `margin` (m), in order of time.
std::vector<Intrusion> intrusions(const ClearanceTrack& track, double margin, const MarginOptions& options);

/// outcome() of each of `margins` (m), which are finite and not negative, in one pass.
std::vector<MarginOutcome> outcomes(const ClearanceTrack& track, std::span<const double> margins,
                                    const MarginOptions& options);

/// Each stop is judged by itself: until the margin is broken, robot and person are in step with the
/// recording, and after the intrusion they are again.
MarginOutcome outcome(const ClearanceTrack& track, double margin, const MarginOptions& options);

}  // namespace abstand::margin
