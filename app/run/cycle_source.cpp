#include "app/run/cycle_source.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

#include "core/base/pacer.hpp"
#include "core/scene/pair_threads.hpp"

namespace abstand::run {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

void add(const scene::StepCounts& counts, RunSummary::Work& work) {
  work.checked += counts.checked;
  work.rested += counts.rested;
  work.beyond += counts.beyond;
  work.deferred += counts.deferred;
  work.longest_wait = std::max(work.longest_wait, counts.longest_wait);
}

/// Groups of pairs in live mode: the scene file's with one for the rest, or one for each core.
std::vector<std::vector<PairId>> liveGroups(const session::Session& session) {
  const scene::Scene& scene = session.scene();
  std::vector<std::vector<PairId>> groups;
  if (session.description().threads.empty()) {
    groups.resize(std::max(1u, std::thread::hardware_concurrency()));
    for (std::size_t i = 0; i < scene.pairs().size(); ++i)
      groups[i % groups.size()].push_back(PairId(static_cast<std::uint32_t>(i)));
    return groups;
  }
  for (const session::PairGroup& group : session.pairGroups()) groups.push_back(group.pairs);
  return groups;
}

/// Runs a lock-step cycle; returns the seconds that `step` and copying its results took.
template <class Step>
double measured(PassState& state, Step step) {
  if (state.summary.profile) state.summary.profile->begin();
  const auto begin = Clock::now();
  step();
  state.takeRenewed();
  state.watchPoses();
  const double worked = since(begin);
  if (state.summary.profile) state.summary.profile->end(worked);
  add(state.session.scene().counts(), state.summary.work);
  return worked;
}

/// One step of the session for each frame; cold starts at block boundaries (kColdStart).
class LockStep : public CycleSource {
 public:
  LockStep(PassState& state, std::size_t first) : state_(state), frame_(first) {}

  void frame(double t, const CycleDone& done) override {
    done(t, measured(state_, [&] {
           if (frame_++ % kColdStart == 0) state_.session.scene().startCold();
           state_.session.step(t);
         }));
  }
  const std::vector<PairId>& updated() const override { return state_.session.scene().updated(); }

 private:
  PassState& state_;
  std::size_t frame_;
};

/// The closed loop in lock step: one cycle for each millisecond.
class LoopInLockStep : public CycleSource {
 public:
  LoopInLockStep(PassState& state, double t) : state_(state), loop_(state.session, t) {
    state_.summary.cycles = 0;
  }

  void frame(double t, const CycleDone& done) override {
    // The cycle nearest to the frame is the last one run.
    while (loop_.time() <= t + 0.5 * loop::ClosedLoop::kStep) {
      const double at = loop_.time();
      const double worked = measured(state_, [&] { loop_.step(); });
      ++state_.summary.cycles;
      done(at, worked);
    }
  }
  const std::vector<PairId>& updated() const override { return state_.session.scene().updated(); }
  const loop::ClosedLoop* loop() const override { return &loop_; }
  void finish() override { state_.summary.robots = loop::reportOf(loop_); }

 private:
  PassState& state_;
  loop::ClosedLoop loop_;
};

/// The closed loop with its pairs on threads of their own.
class LoopLive : public CycleSource {
 public:
  LoopLive(PassState& state, double t)
      : state_(state), live_(state.session, t, liveGroups(state.session), state.options.pace) {
    state_.summary.cycles = 0;
  }

  void frame(double t, const CycleDone& done) override {
    while (live_.loop().time() <= t + 0.5 * loop::ClosedLoop::kStep) {
      const double at = live_.loop().time();
      const double worked = live_.cycle(state_.results);
      state_.watchPoses();
      ++state_.summary.cycles;
      done(at, worked);
    }
  }
  const std::vector<PairId>& updated() const override { return state_.all; }
  const loop::ClosedLoop* loop() const override { return &live_.loop(); }
  void finish() override {
    add(live_.counts(), state_.summary.work);
    state_.summary.robots = loop::reportOf(live_.loop());
  }

 private:
  PassState& state_;
  LiveLoop live_;
};

/// One frame in each period of the recording, with pairs on threads of their own.
class FramesLive : public CycleSource {
 public:
  FramesLive(PassState& state, const std::vector<double>& times)
      : state_(state), threads_(placed(state.session, times.front()).scene()), pacer_{periodOf(times)} {
    for (auto& group : liveGroups(state.session)) threads_.start(threads_.addGroup(std::move(group)));
  }

  void frame(double t, const CycleDone& done) override {
    scene::Scene& scene = state_.session.scene();
    auto begin = Clock::now();
    state_.session.applyMotion(t);
    threads_.publishPoses(scene);
    const double worked = since(begin);
    // The groups use the rest of the period for these poses.
    if (state_.options.pace == LivePace::kRealTime) pacer_.wait();
    begin = Clock::now();
    if (state_.options.pace == LivePace::kRealTime)
      threads_.collect(state_.results);
    else
      settle(threads_, state_.results);
    scene.setResults(state_.results, threads_.resultTimes());
    state_.session.sumEfforts();
    state_.watchPoses();
    done(t, worked + since(begin));
  }
  const std::vector<PairId>& updated() const override { return state_.all; }
  void finish() override { add(threads_.counts(), state_.summary.work); }

 private:
  /// Sets the poses of the first frame, with which the threads start.
  static session::Session& placed(session::Session& session, double t) {
    session.applyMotion(t);
    return session;
  }
  static std::chrono::nanoseconds periodOf(const std::vector<double>& times) {
    const double period =
        times.size() > 1 ? (times.back() - times.front()) / static_cast<double>(times.size() - 1) : 0.001;
    return std::chrono::nanoseconds(static_cast<long>(period * 1e9));
  }

  PassState& state_;
  scene::PairThreads threads_;
  Pacer pacer_;
};

}  // namespace

PassState::PassState(session::Session& session_, const RunOptions& options_, RunSummary& summary_)
    : session(session_),
      options(options_),
      summary(summary_),
      results(session.scene().pairs().size()),
      stale(session.scene().objectCount()) {
  for (std::uint32_t i = 0; i < results.size(); ++i) all.emplace_back(i);
}

void PassState::takeRenewed() {
  const scene::Scene& scene = session.scene();
  for (const PairId id : scene.updated()) results[id.index()] = scene.result(id);
}

void PassState::watchPoses() {
  const auto& objects = session.scene().objects();
  for (std::size_t i = 0; i < stale.size(); ++i) {
    if (scene::isPoseLost(objects[i].pose_state)) stale[i] = true;
  }
}

std::unique_ptr<CycleSource> makeCycleSource(PassState& state, const std::vector<double>& times,
                                             std::size_t first) {
  const bool react = state.options.react && state.session.reacts();
  if (state.options.mode == RunMode::kLockstep) {
    if (react) return std::make_unique<LoopInLockStep>(state, times.front());
    return std::make_unique<LockStep>(state, first);
  }
  if (react) return std::make_unique<LoopLive>(state, times.front());
  return std::make_unique<FramesLive>(state, times);
}

}  // namespace abstand::run
