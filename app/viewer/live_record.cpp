#include "app/viewer/live_record.hpp"

#include <algorithm>
#include <cmath>

#include "core/view/plot_sampler.hpp"

namespace abstand::viewer {
namespace {

constexpr double kRateWindow = 1.0;                    // s
constexpr std::size_t kCopied = std::size_t{1} << 20;  // bytes in one go
// Of a period by which a moment may come early and still be kept.
constexpr double kKeptEarly = 0.25;

bool isSameScene(const moment::SceneCard& a, const moment::SceneCard& b) {
  moment::SceneCard other = b;
  other.server = a.server;
  other.file = a.file;
  return a == other;
}

std::vector<view::PairClass> classesOf(const moment::SceneCard& card) {
  const auto is_of = [](const std::string& body, const std::string& owner) {
    return body.starts_with(owner + "/");
  };
  const auto side_of = [&](std::uint32_t object) {
    const std::string& body = card.objects[object];
    const auto owns = [&](const std::string& owner) { return is_of(body, owner); };
    if (std::any_of(card.people.begin(), card.people.end(), owns)) return view::BodySide::kPerson;
    const bool robot = std::any_of(card.robots.begin(), card.robots.end(),
                                   [&](const auto& owner) { return owns(owner.name); });
    return robot ? view::BodySide::kRobot : view::BodySide::kThing;
  };
  std::vector<view::PairClass> classes;
  for (const auto& [a, b] : card.pairs) classes.push_back(view::pairClassOf(side_of(a), side_of(b)));
  return classes;
}

}  // namespace

bool LiveRecord::begin(const moment::SceneCard& card, LinkState state, double now) {
  const std::scoped_lock lock(mutex_);
  if (card_ && !isSameScene(*card_, card)) {
    state_ = LinkState::kOtherScene;
    return false;
  }
  if (!card_) {
    card_ = card;
    sampling_.classes = classesOf(card);
    frame_bytes_ = moment::maxMomentBytes(card);
    kept_rate_ = MomentRing::rateFor(limits_, moment::minMomentBytes(card), kKeptRate);
  }
  rebase_ = newest_.number >= 0 && server_ != card.server;
  server_ = card.server;
  state_ = state;
  last_frame_ = now;
  return true;
}

void LiveRecord::end(LinkState state, bool damaged) {
  const std::scoped_lock lock(mutex_);
  state_ = state;
  damaged_ += damaged ? 1 : 0;
}

void LiveRecord::alive(double now) {
  const std::scoped_lock lock(mutex_);
  last_frame_ = now;
}

bool LiveRecord::add(std::span<const std::byte> frame, const moment::Moment& moment, double now) {
  const std::scoped_lock lock(mutex_);
  last_frame_ = now;
  // The clock of a server that was started again begins at 0.
  if (std::exchange(rebase_, false)) offset_ = newest_.t + std::max(now - last_moment_, 0.0) - moment.shown.t;
  const double t = moment.shown.t + offset_;
  if (const auto header = moment::readHeader(frame)) left_out_ = header->left_out;
  if (newest_.number >= 0 && !(t > newest_.t)) return false;
  newest_.frame.assign(frame.begin(), frame.end());
  if (offset_ != 0.0) {
    moment::Moment moved = moment;
    moved.shown.t = t;
    for (view::RobotSnapshot& robot : moved.shown.robots) robot.since += offset_;
    newest_.frame.resize(frame_bytes_);
    newest_.frame.resize(moment::writeMoment(*moment::readHeader(frame), moved, newest_.frame));
  }
  newest_.t = t;
  ++newest_.number;
  last_moment_ = now;
  arrivals_.push_back(now);
  while (arrivals_.front() < now - kRateWindow) arrivals_.pop_front();
  if (state_ == LinkState::kFile || t >= due_ - kKeptEarly / kept_rate_) {
    due_ = std::max(due_ + 1.0 / kept_rate_, t);
    ring_.add(t, newest_.frame);
  }
  logStops(moment);
  addSample(moment, t);
  return true;
}

void LiveRecord::logStops(const moment::Moment& moment) {
  const auto& robots = moment.shown.robots;
  if (stops_.empty())
    for (const view::RobotSnapshot& robot : robots)
      stops_.push_back({{}, robot.state, robot.since + offset_});
  for (std::size_t i = 0; i < robots.size(); ++i) {
    Stops& stops = stops_[i];
    const double since = robots[i].since + offset_;
    if (robots[i].state == stops.state) continue;
    stops.log.add({since, stops.state, robots[i].state, robots[i].cause, std::max(since - stops.since, 0.0)});
    stops.state = robots[i].state;
    stops.since = since;
  }
}

void LiveRecord::copyLogs(std::vector<view::RobotSnapshot>& robots) const {
  const std::scoped_lock lock(mutex_);
  for (std::size_t i = 0; i < std::min(robots.size(), stops_.size()); ++i) robots[i].log = stops_[i].log;
}

view::PlotSample LiveRecord::sampleOf(const moment::Moment& moment, double t) {
  const view::SceneSnapshot& s = moment.shown;
  view::PlotSample sample;
  sample.t = t;
  // The server does not know the masses of links.
  sample.peak_torque.gravity = sample.peak_torque.motion = kNaN;
  view::fillSample(sampling_.classes, s, sample);
  std::vector<double>& margins = sampling_.margins;
  bool edited = false;
  margins.resize(s.objects.size(), kNaN);
  for (std::size_t i = 0; i < s.objects.size(); ++i) {
    edited = edited || (!std::isnan(margins[i]) && margins[i] != s.objects[i].margin);
    margins[i] = s.objects[i].margin;
  }
  sampling_.edits += edited ? 1 : 0;
  sample.margin_edits = sampling_.edits;
  for (const view::TorqueParts& joint : s.joint_torques) {
    sample.peak_torque.contact = std::max(sample.peak_torque.contact, std::abs(joint.contact));
    sample.peak_torque.reaction = std::max(sample.peak_torque.reaction, std::abs(joint.reaction));
  }
  sample.cycle_s = 1e-6 * s.cycle_us;
  sample.played = true;
  return sample;
}

void LiveRecord::addSample(const moment::Moment& moment, double t) {
  samples_.push_back(sampleOf(moment, t));
  while (samples_.front().t < t - limits_.seconds) {
    samples_.pop_front();
    drained_ -= drained_ > 0 ? 1 : 0;
  }
}

std::optional<moment::SceneCard> LiveRecord::card() const {
  const std::scoped_lock lock(mutex_);
  return card_;
}

LinkStatus LiveRecord::status(double now) const {
  const std::scoped_lock lock(mutex_);
  LinkStatus status;
  status.state = state_;
  status.rate = static_cast<double>(
      std::count_if(arrivals_.begin(), arrivals_.end(), [&](double t) { return t >= now - kRateWindow; }));
  status.moment_age = now - last_moment_;
  status.frame_age = now - last_frame_;
  status.damaged = damaged_;
  status.left_out = left_out_;
  return status;
}

LiveRecord::Span LiveRecord::span() const {
  const std::scoped_lock lock(mutex_);
  if (ring_.empty()) return {};
  return {ring_.time(ring_.begin()), newest_.t, ring_.size(), ring_.bytes(), kept_rate_};
}

bool LiveRecord::copyNewest(Copy& copy) const {
  const std::scoped_lock lock(mutex_);
  if (newest_.number < 0 || newest_.number == copy.number) return false;
  copy = newest_;
  return true;
}

bool LiveRecord::copyAt(double t, int steps, Copy& copy) const {
  const std::scoped_lock lock(mutex_);
  const auto found = ring_.at(t);
  if (!found) return false;
  const auto wanted = static_cast<long>(*found) + steps;
  const auto number = static_cast<std::size_t>(
      std::clamp(wanted, static_cast<long>(ring_.begin()), static_cast<long>(ring_.end()) - 1));
  const auto frame = ring_.frame(number);
  copy.number = newest_.number;
  copy.t = ring_.time(number);
  copy.frame.assign(frame.begin(), frame.end());
  return true;
}

std::size_t LiveRecord::copyFrames(std::size_t number, std::vector<std::byte>& out) const {
  const std::scoped_lock lock(mutex_);
  number = std::max(number, ring_.begin());
  for (; number < ring_.end() && out.size() < kCopied; ++number) {
    const auto frame = ring_.frame(number);
    out.insert(out.end(), frame.begin(), frame.end());
  }
  return number;
}

void LiveRecord::drainPlot(std::vector<view::PlotSample>& out) {
  const std::scoped_lock lock(mutex_);
  out.insert(out.end(), samples_.begin() + static_cast<std::ptrdiff_t>(drained_), samples_.end());
  drained_ = samples_.size();
}

void LiveRecord::replayPlot() {
  const std::scoped_lock lock(mutex_);
  drained_ = 0;
}

}  // namespace abstand::viewer
