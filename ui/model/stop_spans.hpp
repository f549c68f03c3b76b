// When robots stood, as far as it was played.
#pragma once

#include <vector>

#include "core/view/snapshot.hpp"
#include "ui/model/time_axis.hpp"

namespace abstand::ui {

/// One stand of a robot.
struct StopSpan {
  TimeRange range;  ///< s, from the change to a stop until the robot ran again or was seen last
  int robot{-1};    ///< index of SceneOutline::reacting
  safety::StopState state{safety::StopState::kProtectiveStop};  ///< in which it began
  safety::StopCause cause;
};

/// Gathers the stops of the robots that react from one snapshot to the next. GUI thread only.
class StopSpans {
 public:
  /// True where something has changed. A new beginning of the closed loop keeps the stops that were seen
  /// before, each until its beginning is played again. With another number of robots all are forgotten.
  bool add(const view::SceneSnapshot& snapshot);
  /// Of all robots, in the order in which they began to be seen.
  const std::vector<StopSpan>& spans() const { return spans_; }

 private:
  bool forgetPlayedAgain(double from, double to);

  long loops_{-1};
  double last_t_{0.0};  ///< s, of the snapshot before
  std::vector<StopSpan> spans_;
  std::vector<long> seen_in_;  ///< of each span: SceneSnapshot::loops
  std::vector<int> open_;      ///< of each robot: the number of its span that is under way, or -1
};

}  // namespace abstand::ui
