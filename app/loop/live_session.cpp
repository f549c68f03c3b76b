#include "app/loop/live_session.hpp"

#include <sys/prctl.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "core/scene/cycle_statistics.hpp"
#include "core/view/plot_sampler.hpp"

namespace abstand::loop {
namespace {

constexpr double kPeriod = 1e-3;          // s, the rate required by the thesis
constexpr int kMaxPeriods = 50;           // largest step chosen by the loop
constexpr int kPublishEvery = 4;          // rounds; the window draws at 60 Hz
constexpr double kMaxRound = 0.02;        // s of wall time for cycles between two checks of the commands
constexpr long kStatisticsWindow = 2000;  // cycles after which the displayed statistics restart
constexpr double kHeadroom = 1.3;         // times a cycle's median, for the loop's other work

template <class... Ts>
struct Overload : Ts... {
  using Ts::operator()...;
};
template <class... Ts>
Overload(Ts...) -> Overload<Ts...>;

view::SceneSnapshot sized(const session::Session& session) {
  view::SceneSnapshot s;
  session.capture(0.0, s);
  s.robots.resize(session.description().mechanisms.size());
  s.joint_torques.resize(session.jointEfforts().size());
  s.groups.resize(session.pairGroups().size());
  s.pair_group.resize(session.scene().pairs().size());
  return s;
}

control::Reaction reactionOf(const session::MechanismDriver& driver,
                             const control::ReactionDescription& reaction,
                             const view::SceneOutline& outline) {
  return {reaction, driver.dof(), outline.pairs.size(), mechanism::dofLimits(driver.mechanism())};
}

}  // namespace

struct LiveSession::Timing {
  explicit Timing(const view::SceneOutline& outline) : sampler(outline) {}
  view::PlotSampler sampler;
  long margin_edits{0};  // so many changes of margins since start
  scene::CycleStatistics statistics{kPeriod};
  double last_s{0.0};
  long cycles{0}, overruns{0};  // while playing, since start or the last change of speed
  int periods{1};
  void restart() { cycles = overruns = 0; }
};

LiveSession::LiveSession(std::unique_ptr<session::Session> session, double t,
                         std::unique_ptr<LiveClock> clock)
    : clock_(clock ? std::move(clock) : std::make_unique<SteadyLiveClock>()),
      session_(std::move(session)),
      outline_(session_->outline()),
      snapshots_(sized(*session_)),
      control_(*session_) {
  for (const auto& m : session_->mechanisms()) torques_of_.emplace_back(*m);
  joint_torques_.resize(outline_.joints.size());
  pending_.reserve(256);
  wishes_.reactions.resize(session_->mechanisms().size());
  for (const auto& thing : session_->description().objects) wishes_.things.push_back(thing.X_WB);
  t_ = std::clamp(t, outline_.start, outline_.end);
  const auto& mechanisms = session_->description().mechanisms;
  for (std::size_t m = 0; m < mechanisms.size(); ++m)
    if (mechanisms[m].reaction)
      outline_.drives.push_back(ReactingRobot::drive(*session_->mechanisms()[m], mechanisms[m]));
  try {
    if (session_->reacts()) closeLoop(t_);
  } catch (const std::exception& e) {
    outline_.cannot_react = e.what();
  }
  timing_ = std::make_unique<Timing>(outline_);
  cycle(*timing_);
  publish(*timing_);
  thread_ = std::jthread([this] { loop(*timing_); });
}

LiveSession::~LiveSession() { stop_ = true; }

bool LiveSession::takeSnapshot(view::SceneSnapshot& out) {
  if (!snapshots_.fresh()) return false;
  out = snapshots_.latest();
  return true;
}

void LiveSession::handle(const Command& received, Timing& timing) {
  std::visit(Overload{[&](command::Play c) {
                        if (c.on == playing_) return;
                        playing_ = c.on;
                        if (!c.on) return;
                        timing.restart();
                        pace_.start(clock_->now());
                      },
                      [&](command::Step c) { stepFrames(c.frames, timing); },
                      [&](command::Seek c) {
                        if (std::isfinite(c.t)) goTo(std::clamp(c.t, outline_.start, outline_.end));
                      },
                      [&](command::Speed c) {
                        if (!(c.factor > 0.0) || !std::isfinite(c.factor)) return;
                        if (playing_) pace_.advance(clock_->now(), speed_);
                        speed_ = c.factor;
                        timing.restart();
                      },
                      [&](command::Loop c) { looping_ = c.on; },
                      [&](command::Margin c) {
                        const auto n = static_cast<int>(session_->scene().objectCount());
                        if (c.object < 0 || c.object >= n || !(c.metres >= 0.0) || !std::isfinite(c.metres))
                          return;
                        session_->scene().setMargin(ObjectId(static_cast<std::uint32_t>(c.object)), c.metres);
                        ++timing.margin_edits;
                        needs_cycle_ = true;
                      },
                      [&](command::ClassMargin c) { setClassMargin(c, timing); },
                      [&](command::React c) {
                        if (!session_->reacts() || !outline_.cannot_react.empty()) return;
                        if (c.on == (closed_ != nullptr)) return;
                        closed_.reset();
                        if (c.on) closeLoop(t_);
                        ++loops_;
                        pace_.drop();
                        needs_cycle_ = true;
                        timing.statistics.clear();
                        timing.restart();
                      },
                      [&](command::ResetStops) {
                        if (closed_) closed_->resetStops();
                      },
                      [&](command::Torques c) {
                        wishes_.torques = c.on;
                        if (closed_) closed_->setTorques(c.on);
                      },
                      [&](command::SetGroup c) {
                        control_.setState(c.group, c.state, t_);
                        needs_cycle_ = true;
                      },
                      [&](command::AddPair c) {
                        control_.add(c.group, pair(c.pair), t_);
                        needs_cycle_ = true;
                      },
                      [&](command::RemovePair c) {
                        control_.remove(pair(c.pair), t_);
                        needs_cycle_ = true;
                      },
                      [&](command::PoseJoint c) { poseJoint(c.joint, c.value); },
                      [&](command::FollowMotion c) { followMotion(c.robot); },
                      [&](const command::PlaceThing& c) { placeThing(c); },
                      [&](const command::Laws& c) { exchangeLaws(c.robot, *c.next); },
                      [&](const command::Poke& c) { setPoke(c); }, [&](command::EndPoke) { endPoke(); }},
             received);
  needs_snapshot_ = true;
}

void LiveSession::setClassMargin(const command::ClassMargin& wanted, Timing& timing) {
  if (std::isnan(wanted.metres) || wanted.metres == kInfinity) return;
  const std::optional<double> margin =
      wanted.metres < 0.0 ? std::nullopt : std::optional<double>(wanted.metres);
  for (std::size_t p = 0; p < outline_.pairs.size(); ++p)
    if (view::pairClassOf(outline_, outline_.pairs[p]) == wanted.pair_class)
      session_->scene().setPairMargin(PairId(static_cast<std::uint32_t>(p)), margin);
  ++timing.margin_edits;
  needs_cycle_ = true;
}

void LiveSession::placeThing(const command::PlaceThing& wanted) {
  const std::size_t first = session_->scene().objectCount() - wishes_.things.size();
  const std::size_t i = static_cast<std::size_t>(wanted.object) - first;
  if (wanted.object < 0 || i >= wishes_.things.size()) return;
  const ObjectId id(static_cast<std::uint32_t>(wanted.object));
  if (!session_->placeThing(id, wanted.X_WB.value_or(wishes_.things[i]))) return;
  if (closed_ && session_->description().objects[i].mass) goTo(t_);
  needs_cycle_ = true;
}

void LiveSession::goTo(double t) {
  pace_.drop();
  begin(t);
}

/// Starts reacting robots on their plans at `t`.
void LiveSession::begin(double t) {
  t_ = t;
  if (closed_) {
    closed_.reset();  // releases held objects before the next loop takes them
    closeLoop(t);
    ++loops_;
  }
  needs_cycle_ = true;
}

void LiveSession::closeLoop(double t) {
  closed_ = std::make_unique<ClosedLoop>(*session_, t, wishes_.reactions);
  closed_->setTorques(wishes_.torques);
  closed_->setPoke(wishes_.poke);
}

/// Index of the session's mechanisms; -1: there is no such robot.
int LiveSession::mechanismOf(int robot) const {
  const auto& mechanisms = session_->description().mechanisms;
  for (std::size_t m = 0; m < mechanisms.size(); ++m)
    if (mechanisms[m].reaction && robot-- == 0) return static_cast<int>(m);
  return -1;
}

command::Laws LiveSession::laws(int robot, const control::ReactionDescription& reaction) const {
  const int m = mechanismOf(robot);
  if (m < 0) throw UsageError("found robot " + std::to_string(robot) + ", expected one with a reaction");
  const std::string problem = view::driveProblem(outline_.drives[static_cast<std::size_t>(robot)], reaction);
  if (!problem.empty()) throw UsageError(problem);
  const session::MechanismDriver& driver = *session_->mechanisms()[static_cast<std::size_t>(m)];
  if (reaction.braking) {
    config::requireNumbers(*reaction.braking);
    safety::BrakingPath(reaction.braking->path, driver.dof());  // throws if it does not fit
  }
  return {robot, std::make_shared<control::Reaction>(reactionOf(driver, reaction, outline_))};
}

void LiveSession::exchangeLaws(int robot, control::Reaction& next) {
  const int m = mechanismOf(robot);
  if (m < 0) return;
  const auto i = static_cast<std::size_t>(m);
  const control::ReactionDescription& now =
      wishes_.reactions[i] ? *wishes_.reactions[i] : *session_->description().mechanisms[i].reaction;
  const bool restarts = view::drivenOtherwise(now, next.description());
  wishes_.reactions[i] = next.description();
  if (!closed_) return;
  if (restarts)
    goTo(t_);
  else
    closed_->exchangeLaws(i, next);
}

void LiveSession::setPoke(const command::Poke& wanted) {
  const auto n = static_cast<int>(session_->scene().objectCount());
  if (wanted.object < 0 || wanted.object >= n || !wanted.p_B.allFinite() || !wanted.target_W.allFinite())
    return;
  wishes_.poke = Poke{ObjectId(static_cast<std::uint32_t>(wanted.object)), wanted.p_B, wanted.target_W};
  wishes_.poke_end = clock_->now() + Poke::kTimeout;
  if (closed_) closed_->setPoke(wishes_.poke);
}

void LiveSession::expirePoke() {
  if (wishes_.poke && clock_->now() > wishes_.poke_end) endPoke();
}

void LiveSession::endPoke() {
  wishes_.poke.reset();
  if (closed_) closed_->setPoke(std::nullopt);
  needs_snapshot_ = true;
}

std::optional<PairId> LiveSession::pair(int index) const {
  if (index < 0 || static_cast<std::size_t>(index) >= session_->scene().pairs().size()) return std::nullopt;
  return PairId(static_cast<std::uint32_t>(index));
}

void LiveSession::poseJoint(int joint, double value) {
  for (std::size_t m = 0; m < outline_.robots.size(); ++m) {
    const view::RobotCard& robot = outline_.robots[m];
    const int own = joint - robot.first_joint;
    if (own < 0 || own >= robot.joints) continue;
    if (session_->mechanisms()[m]->poseByHand(own, value)) needs_cycle_ = true;
  }
}

void LiveSession::followMotion(int robot) {
  if (robot < 0 || static_cast<std::size_t>(robot) >= outline_.robots.size()) return;
  const auto m = static_cast<std::size_t>(robot);
  if (!session_->mechanisms()[m]->byHand()) return;
  session_->mechanisms()[m]->followMotion();
  // Its plan has gone on without it: all begin anew, as after a seek.
  if (closed_ && closed_->robots()[m]) begin(t_);
  needs_cycle_ = true;
}

/// Joint efforts at the displayed time.
void LiveSession::findTorques() {
  const std::vector<double>& contact = session_->jointEfforts();
  std::size_t first = 0;
  for (std::size_t m = 0; m < torques_of_.size(); ++m) {
    const auto n = static_cast<std::size_t>(session_->mechanisms()[m]->dof());
    const std::span<view::TorqueParts> own = std::span(joint_torques_).subspan(first, n);
    const bool by_hand = session_->mechanisms()[m]->byHand();
    const ReactingRobot* robot = closed_ && !by_hand ? closed_->robots()[m].get() : nullptr;
    if (by_hand)
      torques_of_[m].updateAtRest(own);
    else if (robot)
      torques_of_[m].update(robot->qd(), robot->qdd(), own);
    else
      torques_of_[m].updateRecorded(t_, own);
    for (std::size_t i = 0; i < n; ++i) {
      own[i].contact = contact[first + i];
      own[i].reaction = robot ? robot->torque()[i] : 0.0;
    }
    first += n;
  }
}

void LiveSession::stepFrames(int frames, Timing& timing) {
  playing_ = false;
  const double period = outline_.frame_period;
  if (!closed_ || frames <= 0) return goTo(std::clamp(t_ + frames * period, outline_.start, outline_.end));
  // A frame may not be a whole number of cycles: counted from the start to avoid accumulated rounding.
  const double frame = std::round((t_ - outline_.start) / period) + frames;
  const double t = std::min(outline_.start + frame * period, outline_.end);
  while (closed_->time() <= t + 0.5 * ClosedLoop::kStep && !stop_) reactOnce(timing);
}

void LiveSession::publish(const Timing& timing) {
  view::SceneSnapshot& s = snapshots_.back();
  session_->capture(t_, s);
  if (closed_) {
    closed_->capture(s);
  } else {
    s.robots.clear();
    s.loop_start = kNaN;
    s.movers.poke = {};
  }
  s.joint_torques = joint_torques_;
  s.torques_on = wishes_.torques;
  control_.capture(s);
  s.loops = loops_;
  s.step = step_;
  s.cycle_us = 1e6 * timing.last_s;
  s.cycle_median_us = 1e6 * timing.statistics.median();
  s.cycle_p99_us = 1e6 * timing.statistics.p99();
  s.played_cycles = timing.cycles;
  s.overruns = timing.overruns;
  s.step_s = step(timing);
  s.real_time_factor = playing_ ? pace_.factor() : kNaN;
  s.playing = playing_;
  snapshots_.publish();
  needs_snapshot_ = false;
}

/// Wall time (s) available for a cycle.
double LiveSession::step(const Timing& timing) const {
  return closed_ ? ClosedLoop::kStep / speed_ : kPeriod * timing.periods;
}

template <class Work>
void LiveSession::timed(Timing& timing, Work work) {
  const double begin = clock_->now();
  work();
  timing.last_s = clock_->now() - begin;
  if (playing_) {
    ++timing.cycles;
    if (timing.last_s > step(timing)) ++timing.overruns;
  }
  if (timing.statistics.count() >= kStatisticsWindow) timing.statistics.clear();
  timing.statistics.add(timing.last_s);
  timing.periods =
      closed_ ? 1
              : std::clamp(static_cast<int>(std::ceil(kHeadroom * timing.statistics.median() / kPeriod)), 1,
                           kMaxPeriods);
  ++step_;
  needs_cycle_ = false;
  needs_snapshot_ = true;
  view::PlotSample sample;
  sample.t = t_;
  timing.sampler.fill(session_->scene(), sample);
  sample.margin_edits = timing.margin_edits;
  sample.cycle_s = timing.last_s;
  sample.step_s = step(timing);
  sample.played = playing_;
  findTorques();
  for (const view::TorqueParts& joint : joint_torques_) {
    const auto raise = [](double& largest, double value) { largest = std::fmax(largest, std::abs(value)); };
    raise(sample.peak_torque.contact, joint.contact);
    raise(sample.peak_torque.reaction, joint.reaction);
    raise(sample.peak_torque.gravity, joint.gravity);
    raise(sample.peak_torque.motion, joint.motion);
  }
  plot_.push(sample);  // lost if the ring is not read
}

/// Shows t_ without advancing.
void LiveSession::cycle(Timing& timing) {
  if (closed_) t_ = closed_->time();
  timed(timing, [this] { closed_ ? closed_->refresh() : session_->step(t_); });
}

void LiveSession::reactOnce(Timing& timing) {
  t_ = closed_->time();
  timed(timing, [this] { closed_->step(); });
}

/// Restarts at the beginning, or stops.
void LiveSession::end() {
  if (looping_ && outline_.end > outline_.start) return begin(outline_.start);
  playing_ = false;
  needs_snapshot_ = true;
}

void LiveSession::play(Timing& timing) {
  pace_.advance(clock_->now(), speed_);
  closed_ ? playClosed(timing) : playRecorded(timing);
}

/// Advances to the current wall time, at most to the end, which is shown before the next round starts.
void LiveSession::playRecorded(Timing&) {
  pace_.limitLag(speed_, speed_ * PlayPace::kMaxLag);
  if (t_ >= outline_.end) end();
  if (!playing_) return;
  const double dt = std::min(pace_.due(), outline_.end - t_);
  pace_.played(dt);
  t_ = pace_.due() > 0.0 ? outline_.end : t_ + dt;
  needs_cycle_ = true;
  if (t_ >= outline_.end && !looping_) end();
}

void LiveSession::playClosed(Timing& timing) {
  const double until = clock_->now() + kMaxRound;
  while (pace_.due() >= ClosedLoop::kStep && playing_ && !stop_) {
    expirePoke();
    // The last cycle is the one nearest to the end.
    if (closed_->time() > outline_.end + 0.5 * ClosedLoop::kStep) end();
    if (!playing_) return;
    reactOnce(timing);
    pace_.played(ClosedLoop::kStep);
    if (clock_->now() >= until) break;
  }
  pace_.limitLag(speed_, 0.0);
}

void LiveSession::loop(Timing& timing) {
  ::prctl(PR_SET_NAME, "loop");
  double next = clock_->now();    // s, start of the next round
  int rounds_since_snapshot = 0;  // rounds since the last snapshot
  while (!stop_) {
    pending_.clear();
    commands_.drainInto(pending_);
    for (const Command& c : pending_) handle(c, timing);
    const bool commanded = !pending_.empty();
    expirePoke();
    if (playing_) play(timing);
    if (needs_cycle_) cycle(timing);
    ++rounds_since_snapshot;
    if (needs_snapshot_ &&
        (commanded || !playing_ || rounds_since_snapshot >= kPublishEvery || timing.periods > 1)) {
      publish(timing);
      rounds_since_snapshot = 0;
    }
    // After a late round the next ones do not come in bursts.
    next = std::max(next + kPeriod * timing.periods, clock_->now());
    clock_->sleepUntil(next);
  }
}

}  // namespace abstand::loop
