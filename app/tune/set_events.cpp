#include "app/tune/set_events.hpp"

#include <algorithm>

#include "app/tune/margin_strategy.hpp"
#include "app/tune/pair_rows.hpp"

namespace abstand::tune {
namespace {

/// Follows one recording and collects its events.
class SetWatch {
 public:
  SetWatch(const TunedRecording& recording, const PartFrames& frames, const MarginRules& rules,
           const margin::MarginOptions& options)
      : recording_(recording),
        frames_(frames),
        margins_(marginsOf(recording, rules)),
        limit_(options.limit),
        stream_(options) {
    stream_.on_stop = [this](const margin::Stop& stop) { end(stop); };
  }

  void add(std::size_t index, const margin::PairFrame& frame) {
    std::size_t nearest = 0;
    std::optional<std::size_t> teller;
    double shortfall = 0.0, needed_by_teller = 0.0;
    for (std::size_t p = 0; p < margins_.size(); ++p) {
      if (frame.clearance[p] < frame.clearance[nearest]) nearest = p;
      const double needed = margins_[p].at(frame.robot_speed[p], frame.person_speed[p]);
      const double short_by = needed - frame.clearance[p];
      if (!(frame.clearance[p] < needed) || (teller && !(short_by > shortfall))) continue;
      teller = p;
      shortfall = short_by;
      needed_by_teller = needed;
    }
    const double clearance = frame.clearance[nearest];
    stream_.add({frame.t, teller.has_value(), clearance, frame.between, frame.braking});
    if (!teller) {
      if (frame.between <= limit_) addBetweenFrames(index);
      running_ = false;
      return;
    }
    if (!running_) {
      event_ = {};
      event_.min_clearance = kInfinity;
      tell(event_, *teller, needed_by_teller);
      event_.told_clearance = frame.clearance[*teller];
      event_.told_robot_speed = frame.robot_speed[*teller];
      event_.told_person_speed = frame.person_speed[*teller];
    }
    if (!running_ || clearance < least_) {
      least_ = clearance;
      event_.part = pair(nearest).part;
      event_.link = pair(nearest).link;
      event_.t_nearest = frame.t;
    }
    running_ = true;
  }

  std::vector<MarginEvent> finish() {
    stream_.finish();
    std::stable_sort(events_.begin(), events_.end(),
                     [](const MarginEvent& a, const MarginEvent& b) { return a.t0 < b.t0; });
    return std::move(events_);
  }

 private:
  const PassResult::PairOfNames& pair(std::size_t p) const { return recording_.pass.pairs[p]; }

  void tell(MarginEvent& event, std::size_t p, double needed) const {
    event.recording = &recording_;
    event.told_part = pair(p).part;
    event.told_link = pair(p).link;
    event.told_margin = needed;
  }

  void end(const margin::Stop& stop) {
    event_.t0 = stop.begin;
    event_.t1 = stop.end;
    event_.min_clearance = stop.min_clearance;
    event_.braking = stop.braking;
    event_.false_stop = stop.false_stop;
    event_.missed = stop.missed;
    event_.lead_time = stop.lead_time;
    events_.push_back(event_);
  }

  void addBetweenFrames(std::size_t index) {
    const auto& parts = frames_.parts();
    const auto touched = std::min_element(parts.begin(), parts.end(), [&](const auto& a, const auto& b) {
      return a.track.between[index] < b.track.between[index];
    });
    const auto part = static_cast<std::size_t>(std::distance(parts.begin(), touched));
    events_.push_back(betweenFramesEvent(recording_, frames_, part, index));
  }

  const TunedRecording& recording_;
  const PartFrames& frames_;
  std::vector<margin::PairMargin> margins_;
  double limit_;
  margin::OutcomeStream stream_;
  bool running_{false};
  double least_{kInfinity};  ///< m, of the frames of the stop that runs
  MarginEvent event_;        ///< the stop that runs
  std::vector<MarginEvent> events_;
};

}  // namespace

std::vector<MarginEvent> setEvents(const TunedRecording& recording, const MarginRules& rules,
                                   const margin::MarginOptions& options) {
  const PartFrames frames(recording);
  SetWatch watch(recording, frames, rules, options);
  WholeBody body;
  for (const PartClearance& part : frames.parts()) body.take(part.track, options);
  PairRows rows(recording, body.track);
  while (rows.next())
    if (rows.index() >= body.first) watch.add(rows.index(), rows.frame());
  return watch.finish();
}

}  // namespace abstand::tune
