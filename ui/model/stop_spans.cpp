// When robots stood.
#include "ui/model/stop_spans.hpp"

#include <algorithm>

#include "ui/model/stop_text.hpp"

namespace abstand::ui {

bool StopSpans::add(const view::SceneSnapshot& snapshot) {
  bool changed = false;
  if (snapshot.robots.size() != open_.size()) {
    changed = !spans_.empty();
    spans_.clear();
    seen_in_.clear();
    open_.assign(snapshot.robots.size(), -1);
  } else if (snapshot.loops != loops_) {
    std::fill(open_.begin(), open_.end(), -1);
    last_t_ = snapshot.t;
  }
  loops_ = snapshot.loops;
  changed |= forgetPlayedAgain(last_t_, snapshot.t);
  last_t_ = snapshot.t;
  for (std::size_t r = 0; r < open_.size(); ++r) {
    const view::RobotSnapshot& robot = snapshot.robots[r];
    const bool stands = isStop(robot.state);
    if (!stands && open_[r] < 0) continue;
    if (open_[r] < 0) {
      open_[r] = static_cast<int>(spans_.size());
      spans_.push_back({{robot.since, robot.since}, static_cast<int>(r), robot.state, robot.cause});
      seen_in_.push_back(loops_);
    }
    // Stops may follow each other: the span goes on.
    TimeRange& span = spans_[static_cast<std::size_t>(open_[r])].range;
    span.to = std::max(span.from, stands ? snapshot.t : robot.since);
    if (!stands) open_[r] = -1;
    changed = true;
  }
  return changed;
}

/// Spans of earlier loops that begin after `from`, and not after `to`.
bool StopSpans::forgetPlayedAgain(double from, double to) {
  bool changed = false;
  for (std::size_t i = spans_.size(); i-- > 0;) {
    const double begin = spans_[i].range.from;
    if (seen_in_[i] == loops_ || !(begin > from) || begin > to) continue;
    spans_.erase(spans_.begin() + static_cast<std::ptrdiff_t>(i));
    seen_in_.erase(seen_in_.begin() + static_cast<std::ptrdiff_t>(i));
    for (int& open : open_)
      if (open > static_cast<int>(i)) --open;
    changed = true;
  }
  return changed;
}

}  // namespace abstand::ui
