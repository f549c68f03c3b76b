// Outcome of a safety margin, computed frame by frame.
#pragma once

#include <functional>
#include <vector>

#include "core/margin/margin_outcome.hpp"

namespace abstand::margin {

/// One frame of a recording, for all pairs that one rule watches together.
struct MarginFrame {
  double t{0.0};                ///< s
  bool inside{false};           ///< a pair is inside its margin: a stop is commanded
  double clearance{kInfinity};  ///< m, minimum
  double between{kInfinity};    ///< m, ClearanceTrack::between, minimum
  double braking{kInfinity};    ///< m, ClearanceTrack::braking, minimum
};

/// Consecutive frames of one kind: all inside, or all outside.
struct MarginFrames {
  double first{0.0}, last{0.0};    ///< s
  double least{kInfinity};         ///< m, of clearance and between of all of them
  double braking{kInfinity};       ///< m, of the first one
  std::optional<double> at_limit;  ///< s, the first frame whose clearance or between is at the limit or below
  long unseen{0};                  ///< frames whose `between` is at the limit or below
};

/// A stop: from the first frame inside a margin to the first one outside again.
struct Stop {
  double begin{0.0}, end{0.0};      ///< s
  double min_clearance{kInfinity};  ///< m, if the robot had not stopped
  double braking{kInfinity};        ///< m, until the robot is at rest
  bool false_stop{false}, missed{false};
  std::optional<double> lead_time;  ///< s, as in Intrusion
};

/// Online version of outcome(): stores no frames, so memory does not grow with the recording. Same rules as
/// outcome(). One thread.
class OutcomeStream {
 public:
  explicit OutcomeStream(const MarginOptions& options) : options_(options) {}

  /// Times must increase.
  void add(const MarginFrame& frame);
  /// The same for consecutive frames that are all outside, or all inside.
  void addOutside(const MarginFrames& frames);
  void addInside(const MarginFrames& frames);
  bool stopping() const { return running_; }
  /// The limit was reached in the stop that is under way.
  bool touched() const { return running_ && stop_.lead_time.has_value(); }
  /// Called at the end of each stop.
  std::function<void(const Stop&)> on_stop;

  /// Call once, after the last frame.
  MarginOutcome finish();

 private:
  struct Interval {
    double from, until;  ///< s
  };
  void start(double t);
  void endStop(double t);

  MarginOptions options_;
  MarginOutcome outcome_;
  bool begun_{false}, running_{false};
  double first_{0.0}, last_{0.0};  ///< s
  Stop stop_;                      ///< the current stop
  double stopped_until_{-kInfinity};
  std::vector<Interval> stopped_;  ///< their ends may lie after the last frame
};

}  // namespace abstand::margin
