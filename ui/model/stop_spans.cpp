// When robots stood.
#include "ui/model/stop_spans.hpp"

#include <algorithm>

#include "ui/model/stop_text.hpp"

namespace abstand::ui {

bool StopSpans::add(const view::SceneSnapshot& snapshot) {
  bool changed = false;
  if (snapshot.loops != loops_ || snapshot.robots.size() != open_.size()) {
    changed = !spans_.empty();
    loops_ = snapshot.loops;
    spans_.clear();
    open_.assign(snapshot.robots.size(), -1);
  }
  for (std::size_t r = 0; r < open_.size(); ++r) {
    const view::RobotSnapshot& robot = snapshot.robots[r];
    const bool stands = isStop(robot.state);
    if (!stands && open_[r] < 0) continue;
    if (open_[r] < 0) {
      open_[r] = static_cast<int>(spans_.size());
      spans_.push_back({{robot.since, robot.since}, static_cast<int>(r), robot.state, robot.cause});
    }
    // Stops may follow each other: the span goes on.
    TimeRange& span = spans_[static_cast<std::size_t>(open_[r])].range;
    span.to = std::max(span.from, stands ? snapshot.t : robot.since);
    if (!stands) open_[r] = -1;
    changed = true;
  }
  return changed;
}

}  // namespace abstand::ui
