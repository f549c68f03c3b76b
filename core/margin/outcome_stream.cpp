#include "core/margin/outcome_stream.hpp"

#include <algorithm>

namespace abstand::margin {

void OutcomeStream::start(double t) {
  if (!begun_) first_ = t;
  begun_ = true;
  last_ = t;
  // Intervals that ended before this frame are not truncated by the end of the recording.
  auto open = stopped_.begin();
  for (; open != stopped_.end() && open->until <= t; ++open)
    outcome_.stopped_time += std::max(0.0, open->until - open->from);
  stopped_.erase(stopped_.begin(), open);
}

void OutcomeStream::add(const MarginFrame& frame) {
  MarginFrames one{frame.t, frame.t, std::min(frame.clearance, frame.between), frame.braking, {}, 0};
  if (one.least <= options_.limit) one.at_limit = frame.t;
  if (frame.between <= options_.limit) one.unseen = 1;
  frame.inside ? addInside(one) : addOutside(one);
}

void OutcomeStream::addOutside(const MarginFrames& frames) {
  if (running_) endStop(frames.first);
  start(frames.first);
  start(frames.last);
  outcome_.min_clearance = std::min(outcome_.min_clearance, frames.least);
  outcome_.unseen += frames.unseen;
}

void OutcomeStream::addInside(const MarginFrames& frames) {
  start(frames.first);
  start(frames.last);
  if (!running_) {
    running_ = true;
    stop_ = {};
    stop_.begin = frames.first;
    stop_.braking = frames.braking;
  }
  if (frames.at_limit && !stop_.lead_time) stop_.lead_time = *frames.at_limit - stop_.begin;
  stop_.min_clearance = std::min(stop_.min_clearance, frames.least);
}

void OutcomeStream::endStop(double t) {
  running_ = false;
  stop_.end = t;
  stop_.false_stop = stop_.min_clearance > options_.limit;
  stop_.missed = stop_.braking <= options_.limit;
  const double until = t + options_.restart_time;
  stopped_.push_back({std::max(stop_.begin, stopped_until_), until});
  stopped_until_ = std::max(stopped_until_, until);
  ++outcome_.stops;
  outcome_.false_stops += stop_.false_stop;
  outcome_.missed_stops += stop_.missed;
  outcome_.min_clearance = std::min(outcome_.min_clearance, stop_.braking);
  if (stop_.lead_time && (!outcome_.lead_time || *stop_.lead_time < *outcome_.lead_time))
    outcome_.lead_time = stop_.lead_time;
  if (on_stop) on_stop(stop_);
}

MarginOutcome OutcomeStream::finish() {
  if (running_) endStop(last_);
  for (const Interval& open : stopped_)
    outcome_.stopped_time += std::max(0.0, std::min(open.until, last_) - open.from);
  stopped_.clear();
  outcome_.time = last_ - first_;
  outcome_.missed_stops += outcome_.unseen;
  return outcome_;
}

}  // namespace abstand::margin
