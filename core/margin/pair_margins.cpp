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
    : options_(options) {
  validate(options);
  if (sets.empty()) throw UsageError("found no set of margins, expected one or more");
  pairs_ = sets.front().size();
  for (std::vector<PairMargin>& margins : sets) {
    if (margins.size() != pairs_)
      throw UsageError("found sets of margins for different numbers of pairs, expected the same");
    for (const PairMargin& margin : margins) validate(margin);
    Set set{std::move(margins), {}, 0.0, OutcomeStream(options)};
    if (std::all_of(set.margins.begin(), set.margins.end(),
                    [](const PairMargin& m) { return m.robot_time == 0.0 && m.person_time == 0.0; }))
      for (const PairMargin& margin : set.margins) set.fixed.push_back(margin.margin);
    for (const double m : set.fixed) set.largest = std::max(set.largest, m);
    sets_.push_back(std::move(set));
  }
  for (auto* list : {&clearance_, &robot_speed_, &person_speed_}) list->resize(at(pairs_));
  least_.assign(pairs_, kInfinity);
  largest_.assign(pairs_, -kInfinity);
  fastest_robot_.assign(pairs_, 0.0);
  fastest_person_.assign(pairs_, 0.0);
  masks_.resize(pairs_);
}

void PairMarginSets::onStop(const std::function<void(std::size_t, const Stop&)>& hear) {
  for (std::size_t s = 0; s < sets_.size(); ++s)
    sets_[s].stream.on_stop = [hear, s](const Stop& stop) { hear(s, stop); };
}

void PairMarginSets::add(const PairFrame& frame) {
  if (frame.clearance.size() != pairs_ || frame.robot_speed.size() != pairs_ ||
      frame.person_speed.size() != pairs_)
    throw UsageError("found a frame with another number of pairs than the margins, expected the same");
  const std::size_t i = block_.size();
  double least = kInfinity;
  for (std::size_t p = 0; p < pairs_; ++p) {
    const double c = frame.clearance[p];
    clearance_[at(p) + i] = c;
    robot_speed_[at(p) + i] = frame.robot_speed[p];
    person_speed_[at(p) + i] = frame.person_speed[p];
    least = std::min(least, c);
    least_[p] = std::min(least_[p], c);
    largest_[p] = std::max(largest_[p], c);
    fastest_robot_[p] = std::max(fastest_robot_[p], frame.robot_speed[p]);
    fastest_person_[p] = std::max(fastest_person_[p], frame.person_speed[p]);
  }
  block_.add({frame.t, false, least, frame.between, frame.braking});
  if (block_.full()) settle();
}

void PairMarginSets::settle() {
  if (block_.empty()) return;
  block_.close(options_.limit);
  block_minimum_ = smallest_maximum_ = kInfinity;
  for (std::size_t p = 0; p < pairs_; ++p) {
    block_minimum_ = std::min(block_minimum_, least_[p]);
    smallest_maximum_ = std::min(smallest_maximum_, largest_[p]);
  }
  for (Set& set : sets_) block_.judge(inside(set), set.stream);
  block_.clear();
  std::fill(least_.begin(), least_.end(), kInfinity);
  std::fill(largest_.begin(), largest_.end(), -kInfinity);
  std::fill(fastest_robot_.begin(), fastest_robot_.end(), 0.0);
  std::fill(fastest_person_.begin(), fastest_person_.end(), 0.0);
  std::fill(masks_.begin(), masks_.end(), std::nullopt);
}

std::uint64_t PairMarginSets::inside(const Set& set) {
  if (!set.fixed.empty()) return insideFixed(set.fixed, set.largest);
  std::uint64_t frames = 0;
  for (std::size_t p = 0; p < pairs_; ++p)
    if (least_[p] < set.margins[p].at(fastest_robot_[p], fastest_person_[p]))
      frames |= inside(p, set.margins[p]);
  return frames;
}

std::uint64_t PairMarginSets::insideFixed(const std::vector<double>& margins, double largest_margin) {
  constexpr std::uint64_t kAll = ~std::uint64_t{0};
  if (!(block_minimum_ < largest_margin)) return 0;
  if (smallest_maximum_ < largest_margin) {
    unsigned within = 0;
    for (std::size_t p = 0; p < pairs_; ++p) within |= largest_[p] < margins[p];
    if (within) return kAll;
  }
  std::uint64_t frames = 0;
  for (std::size_t p = 0; p < pairs_ && frames != kAll; ++p) {
    if (!(least_[p] < margins[p])) continue;
    if (!masks_[p]) masks_[p].emplace(std::span(clearance_).subspan(at(p), block_.size()));
    frames |= masks_[p]->below(margins[p]);
  }
  return frames;
}

std::uint64_t PairMarginSets::inside(std::size_t pair, const PairMargin& margin) const {
  std::uint64_t frames = 0;
  for (std::size_t i = 0; i < block_.size(); ++i) {
    const std::size_t k = at(pair) + i;
    frames |= std::uint64_t{clearance_[k] < margin.at(robot_speed_[k], person_speed_[k])} << i;
  }
  return frames;
}

std::vector<MarginOutcome> PairMarginSets::finish() {
  settle();
  std::vector<MarginOutcome> outcomes;
  for (Set& set : sets_) outcomes.push_back(set.stream.finish());
  return outcomes;
}

}  // namespace abstand::margin
