#include "app/studio/viewer_port.hpp"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace abstand::studio {
namespace {

// s of the timeline: what is kept, and room until it moves along.
constexpr double kKept = 600.0, kRoom = 60.0;
constexpr long kStatisticsWindow = 2000;  // cycles after which the displayed statistics restart

QString words(const char* text) { return QCoreApplication::translate("ViewerPort", text); }

template <class Names, class Name>
bool areNames(const Names& a, const std::vector<std::string>& b, Name name) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](const auto& x, const std::string& y) { return name(x) == y; });
}

/// Nothing is known of the present.
void makeStale(view::SceneSnapshot& s) {
  for (view::ObjectSnapshot& object : s.objects) object.pose_state = scene::PoseState::kStale;
}

/// The pair with the smallest distance that is known.
int nearestOf(const view::SceneSnapshot& s) {
  int nearest = -1;
  double smallest = kInfinity;
  for (std::size_t p = 0; p < s.pairs.size(); ++p) {
    if (!(s.pairs[p].result.distance < smallest)) continue;
    smallest = s.pairs[p].result.distance;
    nearest = static_cast<int>(p);
  }
  return nearest;
}

/// What the server's moments replace in the scene as it is here.
void adapt(view::SceneOutline& outline) {
  outline.recordings.clear();
  outline.falls = false;
  outline.cannot_react.clear();
  outline.reacting.clear();
  outline.reactions.clear();
  for (view::RobotCard& robot : outline.robots) {
    outline.reacting.push_back(robot.name);
    robot.motion.clear();
  }
  for (view::PersonCard& person : outline.people) person.recording.clear();
  for (auto& object : outline.objects) object.moving = true;
}

}  // namespace

QString whyNotShown(const moment::SceneCard& card, const view::SceneOutline& outline) {
  const auto same = [](const std::string& name) { return name; };
  const auto name_of = [](const auto& thing) { return thing.name; };
  if (!areNames(outline.objects, card.objects, name_of))
    return words(QT_TRANSLATE_NOOP("ViewerPort", "The bodies of the scene differ from those of the server."));
  if (!areNames(outline.people, card.people, name_of))
    return words(QT_TRANSLATE_NOOP("ViewerPort", "The people of the scene differ from those of the server."));
  const bool robots = std::equal(outline.robots.begin(), outline.robots.end(), card.robots.begin(),
                                 card.robots.end(), [](const view::RobotCard& a, const auto& b) {
                                   return a.name == b.name && a.joints == static_cast<int>(b.dof);
                                 });
  if (!robots)
    return words(QT_TRANSLATE_NOOP("ViewerPort", "The robots of the scene differ from those of the server."));
  const bool pairs =
      std::equal(outline.pairs.begin(), outline.pairs.end(), card.pairs.begin(), card.pairs.end(),
                 [](const std::pair<int, int>& a, const auto& b) {
                   return a.first == static_cast<int>(b.first) && a.second == static_cast<int>(b.second);
                 });
  if (!pairs || !areNames(outline.pair_groups, card.groups, same))
    return words(QT_TRANSLATE_NOOP("ViewerPort", "The pairs of the scene differ from those of the server."));
  return {};
}

ViewerPort::ViewerPort(Parts parts, std::function<double()> clock)
    : my_(std::move(parts)),
      review_(my_.record, my_.outline),
      clock_(std::move(clock)),
      moment_(moment::makeMoment(*my_.record->card())) {
  adapt(my_.outline);
  const auto kept = my_.record->span();
  my_.outline.frame_period = 1.0 / kept.rate;
  span_.from = kept.first;
  span_.to = my_.link ? std::max(kept.first + kKept, kept.last) + kRoom : kept.last;
  my_.outline.start = span_.from;
  my_.outline.end = span_.to;
  if (!my_.link) {
    follows_ = playing_ = false;
    from_t_ = kept.first;
  }
  my_.record->replayPlot();
}

std::optional<ui::BodyInside> ViewerPort::inside(int object) const {
  const auto i = static_cast<std::size_t>(object);
  if (i >= my_.structures.size()) return {};
  return insideOf(*my_.structures[i]);
}

std::optional<ui::LiveStatus> ViewerPort::live() const {
  using State = ui::LiveStatus::State;
  const viewer::LinkStatus link = my_.record->status(clock_());
  const viewer::LiveRecord::Span kept = my_.record->span();
  ui::LiveStatus status;
  switch (link.state) {
    case viewer::LinkState::kFile:
      status.state = State::kFile;
      break;
    case viewer::LinkState::kOtherScene:
      status.state = State::kOtherScene;
      break;
    case viewer::LinkState::kConnected:
    case viewer::LinkState::kConnecting:
      status.state = link.stale() ? State::kStale : State::kConnected;
      break;
  }
  status.rate = link.rate;
  status.age = link.moment_age;
  status.silence = link.frame_age;
  status.rewound = !follows_;
  // The newest moment may be old, too.
  if (!follows_ && !std::isnan(shown_t_))
    status.behind = std::max(kept.last - shown_t_, 0.0) + (my_.link ? link.moment_age : 0.0);
  status.other_file = my_.other_file;
  status.kept = kept.last - kept.first;
  status.bytes = kept.bytes;
  status.left_out = link.left_out;
  status.can_reset = my_.reset != nullptr;
  return status;
}

void ViewerPort::resetStops() {
  if (my_.reset) my_.reset();
}

void ViewerPort::toLive() {
  if (!my_.link) return;
  follows_ = playing_ = asked_ = true;
  copy_.number = -1;
}

/// s, of what is played again.
double ViewerPort::shownTime() const {
  return playing_ ? from_t_ + speed_ * (clock_() - from_clock_) : from_t_;
}

void ViewerPort::restart(double t) {
  from_t_ = t;
  from_clock_ = clock_();
}

void ViewerPort::play(bool on) {
  if (on == playing_) return;
  const double t = follows_ ? shown_t_ : shownTime();
  playing_ = on;
  // What follows stops at the moment that is shown, and goes on from it.
  if (!on) follows_ = false;
  restart(t);
  asked_ = true;
}

void ViewerPort::seek(double t) {
  if (!std::isfinite(t)) return;
  const viewer::LiveRecord::Span kept = my_.record->span();
  if (my_.link && t > kept.last) return toLive();
  follows_ = false;
  restart(std::clamp(t, kept.first, kept.last));
  asked_ = true;
}

void ViewerPort::step(int frames) {
  restart(follows_ ? shown_t_ : shownTime());
  follows_ = playing_ = false;
  steps_ = frames;
  asked_ = true;
}

void ViewerPort::setSpeed(double factor) {
  if (!(factor > 0.0) || !std::isfinite(factor)) return;
  if (!follows_) restart(shownTime());
  speed_ = factor;
}

void ViewerPort::drainPlot(std::vector<view::PlotSample>& out) { my_.record->drainPlot(out); }

/// The timeline moves along before the newest moment leaves it.
void ViewerPort::moveSpan() {
  const viewer::LiveRecord::Span kept = my_.record->span();
  if (!my_.link || kept.last <= span_.to) return;
  span_ = {kept.last - kKept, kept.last + kRoom};
  my_.outline.start = span_.from;
  my_.outline.end = span_.to;
  my_.record->replayPlot();
}

bool ViewerPort::decode(view::SceneSnapshot& out) {
  if (!moment::readMoment(copy_.frame, moment_)) return false;
  const view::SceneSnapshot& s = moment_.shown;
  out = my_.sized;
  out.t = copy_.t;
  out.objects = s.objects;
  out.pairs = s.pairs;
  out.joint_positions = s.joint_positions;
  out.joint_efforts = s.joint_efforts;
  out.joint_torques = s.joint_torques;
  out.groups = s.groups;
  out.pair_group = s.pair_group;
  out.torques_on = s.torques_on;
  out.robots = s.robots;
  my_.record->copyLogs(out.robots);
  out.movers = s.movers;
  out.cycle_us = s.cycle_us;
  out.nearest_pair = nearestOf(s);
  out.loop_start = kNaN;
  out.work = {};
  out.work.checked = static_cast<long>(std::count_if(
      s.pairs.begin(), s.pairs.end(), [](const view::PairSnapshot& pair) { return !pair.paused; }));
  if (cycles_.count() >= kStatisticsWindow) cycles_.clear();
  cycles_.add(1e-6 * s.cycle_us);
  out.cycle_median_us = 1e6 * cycles_.median();
  out.cycle_p99_us = 1e6 * cycles_.p99();
  out.real_time_factor = follows_ ? 1.0 : playing_ ? speed_ : kNaN;
  return true;
}

bool ViewerPort::takeSnapshot(view::SceneSnapshot& out) {
  moveSpan();
  const bool stale = follows_ && my_.record->status(clock_()).stale();
  const bool changed = std::exchange(was_stale_, stale) != stale;
  bool fresh = false;
  if (follows_) {
    fresh = my_.record->copyNewest(copy_);
  } else if (playing_ || asked_) {
    const double t = shownTime();
    // What is played again catches up.
    if (playing_ && t >= my_.record->span().last) {
      if (my_.link)
        toLive();
      else
        playing_ = false;
      fresh = my_.record->copyAt(t, 0, copy_);
    } else {
      fresh = my_.record->copyAt(t, std::exchange(steps_, 0), copy_) && (asked_ || copy_.t != shown_t_);
    }
    if (fresh && !playing_ && !follows_) restart(copy_.t);
  }
  if (!fresh && !changed && !asked_) return false;
  asked_ = false;
  if (copy_.frame.empty() || !decode(out)) return false;
  if (stale) makeStale(out);
  out.playing = playing_;
  out.step = ++step_;
  shown_t_ = copy_.t;
  return true;
}

}  // namespace abstand::studio
