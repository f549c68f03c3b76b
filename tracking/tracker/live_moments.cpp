#include "tracking/tracker/live_moments.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace abstand::tracking {
namespace {

using Clock = std::chrono::steady_clock;

}  // namespace

LiveMoments::LiveMoments(std::vector<std::unique_ptr<LiveDepth>> cameras) {
  for (std::unique_ptr<LiveDepth>& camera : cameras) sources_.emplace_back().camera = std::move(camera);
}

std::size_t LiveMoments::dropped() const {
  std::size_t sum = 0;
  for (const Source& source : sources_) sum += source.camera->dropped();
  return sum;
}

double LiveMoments::since(Clock::time_point then) const {
  return begin_ ? std::chrono::duration<double>(then - *begin_).count() : 0.0;
}

void LiveMoments::poll(Source& source, double wait) {
  if (source.has_ended) return;
  const LiveDepth::Outcome outcome = source.camera->next(source.live, wait);
  source.has_ended = outcome == LiveDepth::Outcome::kEnded;
  if (outcome != LiveDepth::Outcome::kFrame) return;
  if (!begin_) begin_ = source.live.came;
  source.t = since(source.live.came);
  source.live.frame.t = source.t;
  source.is_new = true;
}

std::size_t LiveMoments::chooseLeader(double now) const {
  std::size_t first = sources_.size();
  for (std::size_t c = 0; c < sources_.size(); ++c) {
    if (sources_[c].has_ended) continue;
    if (now - sources_[c].t <= DepthMoments::kGap) return c;
    first = std::min(first, c);
  }
  return first;
}

void LiveMoments::chooseNewest() {
  for (std::size_t c = 0; c < sources_.size(); ++c) {
    const Source &best = sources_[leader_], &other = sources_[c];
    if (other.is_new && (!best.is_new || other.t > best.t)) leader_ = c;
  }
}

LiveDepth::Outcome LiveMoments::next(DepthMoment& moment, double wait) {
  const Clock::time_point begin = Clock::now();
  for (double left = wait;;) {
    const std::size_t leader = chooseLeader(since(Clock::now()));
    if (leader == sources_.size()) return LiveDepth::Outcome::kEnded;
    poll(sources_[leader], std::min(left, DepthMoments::kGap));
    for (std::size_t c = 0; c < sources_.size(); ++c)
      if (c != leader) poll(sources_[c], 0.0);
    leader_ = leader;
    if (!sources_[leader].is_new) chooseNewest();
    const bool leads = leader_ == leader || since(Clock::now()) - sources_[leader].t > DepthMoments::kGap;
    Source& source = sources_[leader_];
    if (source.is_new && leads) {
      // An image may be read after a later one of another camera.
      if (source.t > last_) {
        fill(moment);
        return LiveDepth::Outcome::kFrame;
      }
      source.is_new = false;
    }
    left = wait - std::chrono::duration<double>(Clock::now() - begin).count();
    if (left <= 0.0) return LiveDepth::Outcome::kNothingYet;
  }
}

void LiveMoments::fill(DepthMoment& moment) {
  moment.t = last_ = sources_[leader_].t;
  moment.frames.assign(sources_.size(), nullptr);
  moment.is_new.assign(sources_.size(), false);
  moment.lag = 0.0;
  for (std::size_t c = 0; c < sources_.size(); ++c) {
    Source& source = sources_[c];
    const double off = std::abs(moment.t - source.t);
    if (!(off <= DepthMoments::kFarthest)) continue;
    moment.frames[c] = &source.live.frame;
    moment.is_new[c] = std::exchange(source.is_new, false);
    moment.lag = std::max(moment.lag, off);
  }
}

}  // namespace abstand::tracking
