// What has been computed of the recording so far.
#include "ui/model/run_history.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::ui {

namespace {
constexpr std::size_t kContactPart = 0, kReactionPart = 1;  // of TorqueParts: what margins change
}

void RunHistory::open(const view::SceneOutline& outline) {
  start_ = outline.start;
  end_ = outline.end;
  period_ = outline.frame_period;
  const auto series = [&](Keep keep) { return FrameSeries(start_, end_, period_, keep); };
  distances_.all = series(Keep::kSmallest);
  distances_.of.fill(distances_.all);
  forces_ = {series(Keep::kLargest), series(Keep::kLargest), series(Keep::kLargest)};
  touch_ = series(Keep::kLargest);
  classes_.clear();
  for (int i = 0; i < kPairClasses; ++i) {
    const auto of = static_cast<PairClass>(i);
    if (std::any_of(outline.pairs.begin(), outline.pairs.end(),
                    [&](const auto& pair) { return pairClassOf(outline, pair) == of; }))
      classes_.push_back(of);
  }
  fresh_from_ = 0.0;
  fresh_to_ = -1.0;
  margin_edits_ = 0;
  has_earlier_ = false;
  torqueOf(-1);
}

const FrameSeries& RunHistory::firstDistance() const {
  const bool people = !classes_.empty() && classes_.front() == PairClass::kPersonRobot;
  return people ? distanceOf(PairClass::kPersonRobot) : distances_.all;
}

void RunHistory::torqueOf(int joint) {
  joint_ = joint;
  for (FrameSeries& series : torques_) series = FrameSeries(start_, end_, period_, Keep::kLargest);
  earlier_torque_ = torques_.front();
}

void RunHistory::add(const view::SceneSnapshot& snapshot) {
  if (joint_ < 0 || static_cast<std::size_t>(joint_) >= snapshot.joint_torques.size()) return;
  const view::TorqueParts& parts = snapshot.joint_torques[static_cast<std::size_t>(joint_)];
  for (std::size_t k = 0; k < view::kTorqueParts; ++k) torques_[k].add(snapshot.t, parts[k]);
}

/// What was computed since the margins changed last belongs to earlier margins from now on.
void RunHistory::retire() {
  if (!(fresh_from_ <= fresh_to_)) return;
  const double last = std::min(fresh_to_, forces_.contact.last()) + 0.5 * period_;
  for (double t = fresh_from_; t <= last; t += forces_.contact.period()) {
    forces_.earlier.add(t, std::fmax(forces_.contact.at(t), forces_.apart.at(t)));
    earlier_torque_.add(t, torques_[kContactPart].at(t));
  }
  for (FrameSeries* series :
       {&forces_.contact, &forces_.apart, &torques_[kContactPart], &torques_[kReactionPart]})
    series->forget(fresh_from_, fresh_to_);
  fresh_from_ = 0.0;
  fresh_to_ = -1.0;
  has_earlier_ = true;
}

void RunHistory::add(const std::vector<view::PlotSample>& samples) {
  for (const view::PlotSample& sample : samples) {
    if (sample.margin_edits != margin_edits_) retire();
    margin_edits_ = sample.margin_edits;
    distances_.all.add(sample.t, sample.min_distance);
    for (std::size_t of = 0; of < distances_.of.size(); ++of)
      distances_.of[of].add(sample.t, sample.class_distance[of]);
    forces_.contact.add(sample.t, sample.contact_force);
    forces_.apart.add(sample.t, sample.virtual_force);
    touch_.add(sample.t, sample.contact_force > 0.0 || sample.min_distance <= 0.0 ? 1.0 : 0.0);
    if (has_earlier_) {
      forces_.earlier.forget(sample.t, sample.t);
      earlier_torque_.forget(sample.t, sample.t);
    }
    const bool first = !(fresh_from_ <= fresh_to_);
    fresh_from_ = first ? sample.t : std::min(fresh_from_, sample.t);
    fresh_to_ = first ? sample.t : std::max(fresh_to_, sample.t);
    if (joint_ >= 0) continue;
    for (std::size_t k = 0; k < view::kTorqueParts; ++k) torques_[k].add(sample.t, sample.peak_torque[k]);
  }
}

bool RunHistory::touched(double from, double to) const { return touch_.between(from, to).high > 0.0; }

bool RunHistory::begins(std::size_t frame, bool touches, bool inside) const {
  const auto holds = [&](std::size_t of) {
    const double t = distances_.all.time(of);
    return (touches && touch_.at(t) > 0.0) || (inside && forces_.apart.at(t) > 0.0);
  };
  return holds(frame) && (frame == 0 || !holds(frame - 1));
}

std::optional<double> RunHistory::nextContact(double t, bool touches, bool inside) const {
  const FrameSeries& frames = distances_.all;
  for (std::size_t f = 0; f < frames.size(); ++f)
    if (frames.time(f) > t + 0.5 * frames.period() && begins(f, touches, inside)) return frames.time(f);
  return {};
}

std::optional<double> RunHistory::previousContact(double t, bool touches, bool inside) const {
  const FrameSeries& frames = distances_.all;
  for (std::size_t f = frames.size(); f-- > 0;)
    if (frames.time(f) < t - 0.5 * frames.period() && begins(f, touches, inside)) return frames.time(f);
  return {};
}

}  // namespace abstand::ui
