#include "core/margin/pair_margins.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"

namespace abstand::margin {

double PairMargin::at(double robot_speed, double person_speed) const {
  // An unknown speed is infinite; it must not turn a factor of 0 into NaN.
  double needed = margin;
  if (robot_time > 0.0) needed += robot_time * std::max(0.0, robot_speed);
  if (person_time > 0.0) needed += person_time * std::max(0.0, person_speed);
  return needed;
}

void validate(const PairMargin& margin) {
  for (const double v : {margin.margin, margin.robot_time, margin.person_time})
    if (!std::isfinite(v) || v < 0.0)
      throw UsageError("found a margin or a time that is negative or not finite, expected 0 or more");
}

PairMarginSets::PairMarginSets(std::vector<std::vector<PairMargin>> sets, const MarginOptions& options)
    : options_(options), sets_(std::move(sets)) {
  validate(options);
  if (sets_.empty()) throw UsageError("found no set of margins, expected one or more");
  pairs_ = sets_.front().size();
  for (const std::vector<PairMargin>& set : sets_) {
    if (set.size() != pairs_)
      throw UsageError("found sets of margins for different numbers of pairs, expected the same");
    for (const PairMargin& margin : set) validate(margin);
    streams_.emplace_back(options);
  }
  least_.resize(pairs_);
  fastest_robot_.resize(pairs_);
  fastest_person_.resize(pairs_);
}

void PairMarginSets::onStop(const std::function<void(std::size_t, const Stop&)>& hear) {
  for (std::size_t s = 0; s < streams_.size(); ++s)
    streams_[s].on_stop = [hear, s](const Stop& stop) { hear(s, stop); };
}

void PairMarginSets::add(const PairFrame& frame) {
  if (frame.clearance.size() != pairs_ || frame.robot_speed.size() != pairs_ ||
      frame.person_speed.size() != pairs_)
    throw UsageError("found a frame with another number of pairs than the margins, expected the same");
  double least = kInfinity;
  for (const double c : frame.clearance) least = std::min(least, c);
  rows_.push_back({frame.t, least, frame.between, frame.braking});
  clearance_.insert(clearance_.end(), frame.clearance.begin(), frame.clearance.end());
  robot_speed_.insert(robot_speed_.end(), frame.robot_speed.begin(), frame.robot_speed.end());
  person_speed_.insert(person_speed_.end(), frame.person_speed.begin(), frame.person_speed.end());
  if (rows_.size() == kBlock) settle();
}

void PairMarginSets::settle() {
  if (rows_.empty()) return;
  std::fill(least_.begin(), least_.end(), kInfinity);
  std::fill(fastest_robot_.begin(), fastest_robot_.end(), 0.0);
  std::fill(fastest_person_.begin(), fastest_person_.end(), 0.0);
  block_least_ = block_between_ = kInfinity;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    block_least_ = std::min({block_least_, rows_[i].clearance, rows_[i].between});
    block_between_ = std::min(block_between_, rows_[i].between);
    for (std::size_t p = 0; p < pairs_; ++p) {
      least_[p] = std::min(least_[p], clearance_[i * pairs_ + p]);
      fastest_robot_[p] = std::max(fastest_robot_[p], robot_speed_[i * pairs_ + p]);
      fastest_person_[p] = std::max(fastest_person_[p], person_speed_[i * pairs_ + p]);
    }
  }
  for (std::size_t s = 0; s < sets_.size(); ++s) judge(s);
  rows_.clear();
  clearance_.clear();
  robot_speed_.clear();
  person_speed_.clear();
}

void PairMarginSets::judge(std::size_t s) {
  const std::vector<PairMargin>& set = sets_[s];
  near_.clear();
  for (std::size_t p = 0; p < pairs_; ++p)
    if (least_[p] < set[p].at(fastest_robot_[p], fastest_person_[p])) near_.push_back(p);
  OutcomeStream& stream = streams_[s];
  if (near_.empty() && !stream.stopping() && block_between_ > options_.limit) {
    stream.addOutside(rows_.front().t, rows_.back().t, block_least_);
    return;
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    bool inside = false;
    for (const std::size_t p : near_) {
      const std::size_t at = i * pairs_ + p;
      inside = inside || clearance_[at] < set[p].at(robot_speed_[at], person_speed_[at]);
    }
    stream.add({rows_[i].t, inside, rows_[i].clearance, rows_[i].between, rows_[i].braking});
  }
}

std::vector<MarginOutcome> PairMarginSets::finish() {
  settle();
  std::vector<MarginOutcome> outcomes;
  for (OutcomeStream& stream : streams_) outcomes.push_back(stream.finish());
  return outcomes;
}

}  // namespace abstand::margin
