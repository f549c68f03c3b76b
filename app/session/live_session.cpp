#include "app/session/live_session.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/base/pacer.hpp"
#include "core/scene/cycle_statistics.hpp"

namespace abstand {
namespace {

constexpr double kPeriod = 1e-3;          // s, the rate that the thesis demands
constexpr int kMostPeriods = 50;          // a cycle longer than this slows the play down instead
constexpr int kPublishEvery = 4;          // cycles; the window draws at 60 Hz
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
  return s;
}

}  // namespace

struct LiveSession::Timing {
  CycleStatistics statistics{kPeriod};
  double last_s{0.0};
  long overruns{0};
  int periods{1};
  double real_time_factor{0.0};
};

LiveSession::LiveSession(std::unique_ptr<Session> session, double t)
    : session_(std::move(session)), outline_(session_->outline()), snapshots_(sized(*session_)) {
  pending_.reserve(256);
  t_ = std::clamp(t, outline_.start, outline_.end);
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

void LiveSession::obey(const Command& wish) {
  std::visit(Overload{[&](command::Play c) { playing_ = c.on; },
                      [&](command::Step c) {
                        playing_ = false;
                        t_ = std::clamp(t_ + c.frames * outline_.frame_period, outline_.start, outline_.end);
                      },
                      [&](command::Seek c) {
                        if (std::isfinite(c.t)) t_ = std::clamp(c.t, outline_.start, outline_.end);
                      },
                      [&](command::Speed c) {
                        if (c.factor > 0.0 && std::isfinite(c.factor)) speed_ = c.factor;
                      },
                      [&](command::Loop c) { looping_ = c.on; },
                      [&](command::Margin c) {
                        const auto n = static_cast<int>(session_->scene().objectCount());
                        if (c.object >= 0 && c.object < n && c.metres >= 0.0 && std::isfinite(c.metres))
                          session_->scene().setMargin(ObjectId(static_cast<std::uint32_t>(c.object)),
                                                      c.metres);
                      }},
             wish);
  dirty_ = true;
}

void LiveSession::advance(double dt) {
  t_ += dt * speed_;
  if (t_ < outline_.end) return;
  if (looping_ && outline_.end > outline_.start) {
    t_ = outline_.start;
  } else {
    t_ = outline_.end;
    playing_ = false;
  }
}

void LiveSession::publish(const Timing& timing) {
  SceneSnapshot& s = snapshots_.back();
  session_->capture(t_, s);
  s.step = step_;
  s.cycle_us = 1e6 * timing.last_s;
  s.cycle_median_us = 1e6 * timing.statistics.median();
  s.cycle_p99_us = 1e6 * timing.statistics.p99();
  s.overruns = timing.overruns;
  s.real_time_factor = timing.real_time_factor;
  s.playing = playing_;
  snapshots_.publish();
}

void LiveSession::cycle(Timing& timing) {
  const auto begin = Clock::now();
  session_->step(t_);
  timing.last_s = std::chrono::duration<double>(Clock::now() - begin).count();
  if (timing.statistics.count() >= kStatisticsWindow) timing.statistics.clear();
  timing.statistics.add(timing.last_s);
  if (timing.last_s > kPeriod) ++timing.overruns;
  timing.periods = std::clamp(static_cast<int>(std::ceil(kHeadroom * timing.statistics.median() / kPeriod)),
                              1, kMostPeriods);
  ++step_;
  dirty_ = false;
  PlotSample sample{t_, kInfinity, 0.0, 0.0};
  const Scene& scene = session_->scene();
  if (const auto nearest = scene.nearest()) sample.min_distance = scene.result(*nearest).distance;
  for (const PairId id : scene.touching())
    sample.peak_force = std::max(sample.peak_force, scene.result(id).force_a.norm());
  for (double e : session_->jointEfforts()) sample.peak_effort = std::max(sample.peak_effort, std::abs(e));
  if (!plot_.push(sample)) samples_lost_.fetch_add(1, std::memory_order_relaxed);
}

void LiveSession::loop(Timing& timing) {
  Pacer pacer{std::chrono::microseconds(static_cast<long>(1e6 * kPeriod))};
  auto mark = Clock::now();
  double played = 0.0;
  while (!stop_) {
    pending_.clear();
    commands_.drainInto(pending_);
    for (const Command& c : pending_) obey(c);
    const bool commanded = !pending_.empty();
    if (playing_) {
      advance(kPeriod * timing.periods);
      played += kPeriod * timing.periods * speed_;
      dirty_ = true;
    }
    if (dirty_) {
      cycle(timing);
      if (commanded || !playing_ || step_ % kPublishEvery == 0 || timing.periods > 1) publish(timing);
    }
    const double wall = std::chrono::duration<double>(Clock::now() - mark).count();
    if (wall > kFactorWindow) {
      timing.real_time_factor = played / wall;
      mark = Clock::now();
      played = 0.0;
    }
    for (int i = 0; i < timing.periods && !stop_; ++i)
      if (!pacer.wait()) break;
  }
}

}  // namespace abstand
