#include "app/loop/live_session.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/base/pacer.hpp"
#include "core/scene/cycle_statistics.hpp"

namespace abstand {
namespace {

constexpr double kPeriod = 1e-3;          // s, the rate that the thesis demands
constexpr int kMostPeriods = 50;          // a cycle longer than this slows the play down instead
constexpr int kPublishEvery = 4;          // rounds; the window draws at 60 Hz
constexpr double kMostDue = 16.0;         // cycles of the closed loop in a round; more makes play slower
constexpr long kStatisticsWindow = 2000;  // cycles after which the shown times forget
constexpr double kFactorWindow = 0.5;     // s over which the real-time factor is taken
constexpr double kHeadroom = 1.3;         // of a cycle's median, for what else the loop does

using Clock = std::chrono::steady_clock;

template <class... Ts>
struct Overload : Ts... {
  using Ts::operator()...;
};
template <class... Ts>
Overload(Ts...) -> Overload<Ts...>;

SceneSnapshot sized(const Session& session) {
  SceneSnapshot s;
  session.capture(0.0, s);
  s.robots.resize(session.description().mechanisms.size());
  return s;
}

}  // namespace

struct LiveSession::Timing {
  CycleStatistics statistics{kPeriod};
  double last_s{0.0};
  long overruns{0};
  int periods{1};
  double played{0.0};  // s, since the real-time factor was taken last
  double real_time_factor{0.0};
};

LiveSession::LiveSession(std::unique_ptr<Session> session, double t)
    : session_(std::move(session)), outline_(session_->outline()), snapshots_(sized(*session_)) {
  pending_.reserve(256);
  t_ = std::clamp(t, outline_.start, outline_.end);
  try {
    if (session_->reacts()) closed_ = std::make_unique<ClosedLoop>(*session_, t_);
  } catch (const std::exception& e) {
    outline_.cannot_react = e.what();
  }
  timing_ = std::make_unique<Timing>();
  cycle(*timing_);
  publish(*timing_);
  thread_ = std::jthread([this] { loop(*timing_); });
}

LiveSession::~LiveSession() { stop_ = true; }

bool LiveSession::takeSnapshot(SceneSnapshot& out) {
  if (!snapshots_.fresh()) return false;
  out = snapshots_.latest();
  return true;
}

void LiveSession::obey(const Command& wish, Timing& timing) {
  std::visit(Overload{[&](command::Play c) { playing_ = c.on; },
                      [&](command::Step c) { stepFrames(c.frames, timing); },
                      [&](command::Seek c) {
                        if (std::isfinite(c.t)) goTo(std::clamp(c.t, outline_.start, outline_.end));
                      },
                      [&](command::Speed c) {
                        if (c.factor > 0.0 && std::isfinite(c.factor)) speed_ = c.factor;
                      },
                      [&](command::Loop c) { looping_ = c.on; },
                      [&](command::Margin c) {
                        const auto n = static_cast<int>(session_->scene().objectCount());
                        if (c.object < 0 || c.object >= n || !(c.metres >= 0.0) || !std::isfinite(c.metres))
                          return;
                        session_->scene().setMargin(ObjectId(static_cast<std::uint32_t>(c.object)), c.metres);
                        dirty_ = true;
                      },
                      [&](command::React c) {
                        if (!session_->reacts() || !outline_.cannot_react.empty()) return;
                        if (c.on == (closed_ != nullptr)) return;
                        closed_.reset();
                        if (c.on) closed_ = std::make_unique<ClosedLoop>(*session_, t_);
                        ++loops_;
                        due_ = 0.0;
                        dirty_ = true;
                        timing.statistics.clear();
                      },
                      [&](command::ResetStops) {
                        if (closed_) closed_->resetStops();
                      }},
             wish);
  fresh_ = true;
}

/// Robots that react stand on their plans there, with nothing behind them.
void LiveSession::goTo(double t) {
  t_ = t;
  due_ = 0.0;
  if (closed_) {
    closed_.reset();  // it lets go of what robots hold before the next one takes it
    closed_ = std::make_unique<ClosedLoop>(*session_, t);
    ++loops_;
  }
  dirty_ = true;
}

void LiveSession::stepFrames(int frames, Timing& timing) {
  playing_ = false;
  due_ = 0.0;
  const double period = outline_.frame_period;
  if (!closed_ || frames <= 0) return goTo(std::clamp(t_ + frames * period, outline_.start, outline_.end));
  // A frame may be no whole number of cycles: from the nearest one, so that roundings do not add up.
  const double frame = std::round((t_ - outline_.start) / period) + frames;
  const double t = std::min(outline_.start + frame * period, outline_.end);
  while (closed_->time() <= t + 0.5 * ClosedLoop::kStep && !stop_) reactOnce(timing);
}

void LiveSession::publish(const Timing& timing) {
  SceneSnapshot& s = snapshots_.back();
  session_->capture(t_, s);
  if (closed_) {
    closed_->capture(s);
  } else {
    s.robots.clear();
    s.loop_start = kNaN;
  }
  s.loops = loops_;
  s.step = step_;
  s.cycle_us = 1e6 * timing.last_s;
  s.cycle_median_us = 1e6 * timing.statistics.median();
  s.cycle_p99_us = 1e6 * timing.statistics.p99();
  s.overruns = timing.overruns;
  s.real_time_factor = timing.real_time_factor;
  s.playing = playing_;
  snapshots_.publish();
  fresh_ = false;
}

template <class Work>
void LiveSession::timed(Timing& timing, Work work) {
  const auto begin = Clock::now();
  work();
  timing.last_s = std::chrono::duration<double>(Clock::now() - begin).count();
  if (timing.statistics.count() >= kStatisticsWindow) timing.statistics.clear();
  timing.statistics.add(timing.last_s);
  if (timing.last_s > kPeriod) ++timing.overruns;
  timing.periods =
      closed_ ? 1
              : std::clamp(static_cast<int>(std::ceil(kHeadroom * timing.statistics.median() / kPeriod)), 1,
                           kMostPeriods);
  ++step_;
  dirty_ = false;
  fresh_ = true;
  PlotSample sample{t_, kInfinity, 0.0, 0.0};
  const Scene& scene = session_->scene();
  if (const auto nearest = scene.nearest()) sample.min_distance = scene.result(*nearest).distance;
  for (const PairId id : scene.touching())
    sample.peak_force = std::max(sample.peak_force, scene.result(id).force_a.norm());
  for (double e : session_->jointEfforts()) sample.peak_effort = std::max(sample.peak_effort, std::abs(e));
  if (!plot_.push(sample)) samples_lost_.fetch_add(1, std::memory_order_relaxed);
}

/// Shows t_ without going on.
void LiveSession::cycle(Timing& timing) {
  if (closed_) t_ = closed_->time();
  timed(timing, [this] { closed_ ? closed_->look() : session_->step(t_); });
}

void LiveSession::reactOnce(Timing& timing) {
  t_ = closed_->time();
  timed(timing, [this] { closed_->step(); });
}

/// Begins again, or stops.
void LiveSession::end() {
  if (looping_ && outline_.end > outline_.start) return goTo(outline_.start);
  playing_ = false;
  fresh_ = true;
}

void LiveSession::play(Timing& timing) {
  if (!closed_) {
    const double dt = kPeriod * timing.periods * speed_;
    timing.played += dt;
    t_ = std::min(t_ + dt, outline_.end);
    dirty_ = true;
    if (t_ == outline_.end) end();
    return;
  }
  for (due_ = std::min(due_ + speed_, kMostDue); due_ >= 1.0 && playing_; due_ -= 1.0) {
    // The last cycle is the one nearest to the end.
    if (closed_->time() > outline_.end + 0.5 * ClosedLoop::kStep) end();
    if (!playing_) return;
    reactOnce(timing);
    timing.played += ClosedLoop::kStep;
  }
}

void LiveSession::loop(Timing& timing) {
  Pacer pacer{std::chrono::microseconds(static_cast<long>(1e6 * kPeriod))};
  auto mark = Clock::now();
  int unseen = 0;  // rounds since the last snapshot
  while (!stop_) {
    pending_.clear();
    commands_.drainInto(pending_);
    for (const Command& c : pending_) obey(c, timing);
    const bool commanded = !pending_.empty();
    if (playing_) play(timing);
    if (dirty_) cycle(timing);
    ++unseen;
    if (fresh_ && (commanded || !playing_ || unseen >= kPublishEvery || timing.periods > 1)) {
      publish(timing);
      unseen = 0;
    }
    const double wall = std::chrono::duration<double>(Clock::now() - mark).count();
    if (wall > kFactorWindow) {
      timing.real_time_factor = timing.played / wall;
      mark = Clock::now();
      timing.played = 0.0;
    }
    for (int i = 0; i < timing.periods && !stop_; ++i)
      if (!pacer.wait()) break;
  }
}

}  // namespace abstand
