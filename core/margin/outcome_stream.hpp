// What a safety margin would have done, frame by frame.
#pragma once

#include <functional>
#include <vector>

#include "core/margin/margin_outcome.hpp"

namespace abstand::margin {

/// One frame of a recording, of all pairs that one rule watches together.
struct MarginFrame {
  double t{0.0};                ///< s
  bool inside{false};           ///< some pair is inside its margin: the robot is told to stop
  double clearance{kInfinity};  ///< m, the least
  double between{kInfinity};    ///< m, ClearanceTrack::between, the least
  double braking{kInfinity};    ///< m, ClearanceTrack::braking, the least
};

/// A stop: from the first frame inside a margin to the first one outside again.
struct Stop {
  double begin{0.0}, end{0.0};      ///< s
  double min_clearance{kInfinity};  ///< m, had the robot not stopped
  double braking{kInfinity};        ///< m, until the robot is at rest
  bool false_stop{false}, missed{false};
  std::optional<double> lead_time;  ///< s, as of Intrusion
};

/// Judges frames as they come and keeps none of them: memory does not grow with the recording. The rules are
/// those of outcome(). One thread.
class OutcomeStream {
 public:
  explicit OutcomeStream(const MarginOptions& options) : options_(options) {}

  /// Times rise.
  void add(const MarginFrame& frame);
  /// Several frames at once, the last one at time `t`, all of them outside and with every `between` above the
  /// limit. `least`: m, of their clearances and of what is between. Not while stopping().
  void addOutside(double first, double t, double least);
  /// Several frames at once, the last one at time `t`, all of them inside. `least`: m, of their clearances
  /// and of what is between: above the limit, unless touched(). `braking`: m, MarginFrame::braking of the
  /// first.
  void addInside(double first, double t, double least, double braking);
  bool stopping() const { return running_; }
  /// The limit was reached in the stop that is under way.
  bool touched() const { return running_ && stop_.lead_time.has_value(); }
  /// Called at the end of each stop.
  std::function<void(const Stop&)> on_stop;

  /// After the last frame; once.
  MarginOutcome finish();

 private:
  struct Interval {
    double from, until;  ///< s
  };
  void start(double t);
  void beginStop(double t, double braking);
  void endStop(double t);

  MarginOptions options_;
  MarginOutcome outcome_;
  bool begun_{false}, running_{false};
  double first_{0.0}, last_{0.0};  ///< s
  Stop stop_;                      ///< the one that runs
  double stopped_until_{-kInfinity};
  std::vector<Interval> stopped_;  ///< whose end may lie behind the last frame
};

}  // namespace abstand::margin
