#include "app/run/run_scene.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

#include "app/run/live_loop.hpp"
#include "app/run/session_log.hpp"
#include "app/session/times_between.hpp"
#include "core/base/error.hpp"
#include "core/base/pacer.hpp"
#include "core/scene/cycle_statistics.hpp"
#include "core/scene/pair_threads.hpp"

namespace abstand {
namespace {

using Clock = std::chrono::steady_clock;

double seconds(Clock::duration d) { return std::chrono::duration<double>(d).count(); }

std::vector<double> timesOf(const Session& session, const RunOptions& options) {
  return timesBetween(options.rate ? session.frameTimes(*options.rate) : session.frameTimes(), options.start,
                      options.end);
}

/// Collects what a frame says of the extremes.
class Extremes {
 public:
  explicit Extremes(const Session& session)
      : session_(session), touching_(session.scene().pairs().size(), false) {}

  /// `renewed`: the pairs whose results may differ from the last frame's; all of them in the first frame.
  void frame(double t, const std::vector<PairResult>& results, const std::vector<PairId>& renewed,
             RunSummary& summary) {
    for (const PairId id : renewed) {
      const std::size_t i = id.index();
      const PairResult& r = results[i];
      // Of equal ones in a frame the first in scene order, whatever the order of `renewed`.
      if (r.distance < distance_ || (r.distance == distance_ && t == distance_t_ && i < distance_pair_)) {
        distance_ = r.distance;
        distance_pair_ = i;
        distance_t_ = t;
      }
      lookAtClearance(id, t, r.distance);
      const double force = r.force_a.norm();
      if (force > force_ || (force == force_ && t == force_t_ && i < force_pair_)) {
        force_ = force;
        force_pair_ = i;
        force_t_ = t;
      }
      const bool touches = r.contacts > 0;
      if (touches != touching_[i]) touching_count_ += touches ? 1 : -1;
      touching_[i] = touches;
    }
    summary.contacts += touching_count_;
    // What is not seen comes nearer although nothing was renewed.
    const Scene& scene = session_.scene();
    for (std::uint32_t i = 0; i < scene.objectCount(); ++i)
      if (scene.object(ObjectId(i)).reach > 0.0)
        for (const PairId id : scene.pairsOf(ObjectId(i)))
          lookAtClearance(id, t, results[id.index()].distance);
  }

  void finish(RunSummary& summary) const {
    if (distance_ < kInfinity) summary.min_distance = extreme(distance_pair_, distance_t_, distance_);
    if (clearance_ < kInfinity) summary.min_clearance = extreme(clearance_pair_, clearance_t_, clearance_);
    if (force_ > 0.0) summary.peak_force = extreme(force_pair_, force_t_, force_);
  }

  RunSummary::Extreme extreme(std::size_t pair, double t, double value) const {
    const Scene& scene = session_.scene();
    const Pair& p = scene.pairs()[pair];
    return {scene.object(p.a).spec.name, scene.object(p.b).spec.name, t, value};
  }

 private:
  void lookAtClearance(PairId id, double t, double distance) {
    const double clearance = distance - session_.scene().reachOf(id);
    const bool first = clearance == clearance_ && t == clearance_t_ && id.index() < clearance_pair_;
    if (!(clearance < clearance_) && !first) return;
    clearance_ = clearance;
    clearance_pair_ = id.index();
    clearance_t_ = t;
  }

  const Session& session_;
  std::vector<bool> touching_;
  long touching_count_{0};
  double distance_{kInfinity}, distance_t_{0.0};
  double clearance_{kInfinity}, clearance_t_{0.0};
  double force_{0.0}, force_t_{0.0};
  std::size_t distance_pair_{0}, clearance_pair_{0}, force_pair_{0};
};

/// Times one pair a frame, in turn, outside the measured cycle.
class PairClock {
 public:
  explicit PairClock(const Scene& scene) : sum_us_(scene.pairs().size()), count_(scene.pairs().size()) {}

  void sample(const Scene& scene) {
    if (sum_us_.empty()) return;
    const Pair& pair = scene.pairs()[next_];
    const Object& a = scene.object(pair.a);
    const Object& b = scene.object(pair.b);
    const auto begin = Clock::now();
    queryPair(*a.spec.structure, a.X_WB, *b.spec.structure, b.X_WB, pair.options, scratch_, result_);
    sum_us_[next_] += 1e6 * seconds(Clock::now() - begin);
    ++count_[next_];
    next_ = (next_ + 1) % sum_us_.size();
  }

  void finish(const Extremes& extremes, RunSummary& summary) const {
    double worst = 0.0;
    for (std::size_t i = 0; i < sum_us_.size(); ++i) {
      if (count_[i] == 0 || sum_us_[i] / count_[i] <= worst) continue;
      worst = sum_us_[i] / count_[i];
      summary.slowest_pair = extremes.extreme(i, 0.0, worst);
    }
  }

 private:
  std::vector<double> sum_us_;
  std::vector<int> count_;
  std::size_t next_{0};
  PairScratch scratch_;
  PairResult result_;
};

/// The groups of pairs that live mode runs: the scene file's, or one group a core.
std::vector<std::vector<PairId>> liveGroups(const Session& session) {
  const Scene& scene = session.scene();
  std::vector<std::vector<PairId>> groups;
  if (session.description().threads.empty()) {
    groups.resize(std::max(1u, std::thread::hardware_concurrency()));
    for (std::size_t i = 0; i < scene.pairs().size(); ++i)
      groups[i % groups.size()].push_back(PairId(static_cast<std::uint32_t>(i)));
    return groups;
  }
  for (const auto& names : session.description().threads) {
    auto& group = groups.emplace_back();
    for (const auto& [a, b] : names) {
      for (std::size_t i = 0; i < scene.pairs().size(); ++i) {
        const std::string& x = scene.object(scene.pairs()[i].a).spec.name;
        const std::string& y = scene.object(scene.pairs()[i].b).spec.name;
        if ((x == a && y == b) || (x == b && y == a)) group.push_back(PairId(static_cast<std::uint32_t>(i)));
      }
    }
  }
  return groups;
}

void add(const StepCounts& counts, RunSummary::Work& work) {
  work.checked += counts.checked;
  work.rested += counts.rested;
  work.beyond += counts.beyond;
  work.put_off += counts.put_off;
  work.longest_wait = std::max(work.longest_wait, counts.longest_wait);
}

std::vector<PairId> allPairs(const Scene& scene) {
  std::vector<PairId> all;
  for (std::uint32_t i = 0; i < scene.pairs().size(); ++i) all.emplace_back(i);
  return all;
}

/// Cycles of one run over all frames; lock step, live and the closed loop differ only in `cycle`, which says
/// of each cycle up to a frame when it was and how many seconds it worked, and in `renewed`, the pairs whose
/// results a cycle may have changed.
template <class Cycle>
void runFrames(const Session& session, const ClosedLoop* loop, const std::vector<double>& times,
               const RunOptions& options, bool last, RunSummary& summary, CycleStatistics& statistics,
               std::vector<PairResult>& results, const std::vector<PairId>& all,
               const std::vector<PairId>& renewed, Cycle cycle) {
  CsvOutputs csv(last ? options.csv : CsvPaths{}, session, loop);
  std::unique_ptr<SessionLog> log;
  if (last && !options.session_log.empty()) log = std::make_unique<SessionLog>(options.session_log, session);
  Extremes extremes(session);
  PairClock pair_clock(session.scene());
  summary.contacts = 0;
  summary.frames = 0;
  bool first = true;
  const auto done = [&](double t, double worked) {
    statistics.add(worked);
    extremes.frame(t, results, first ? all : renewed, summary);
    if (last && options.on_cycle) options.on_cycle(t, results);
    first = false;
  };
  for (const double t : times) {
    if (options.interrupted && options.interrupted()) {
      summary.interrupted = true;
      break;
    }
    cycle(t, done);
    pair_clock.sample(session.scene());
    csv.write(t, session, results);
    if (log) log->write(t, session, results);
    ++summary.frames;
    if (options.progress) options.progress(summary.frames, times.size());
  }
  extremes.finish(summary);
  pair_clock.finish(extremes, summary);
  csv.commit();
  if (log) log->commit();
}

}  // namespace

RunSummary runScene(Session& session, const RunOptions& options) {
  const bool react = options.react && session.reacts();
  const std::vector<double> times = timesOf(session, options);
  Scene& scene = session.scene();
  RunSummary summary;
  summary.objects = scene.objectCount();
  summary.pairs = scene.pairs().size();
  summary.build_ms = session.buildMs();
  summary.memory_bytes = scene.memoryBytes();
  std::vector<PairResult> results(summary.pairs);
  const std::vector<PairId> all = allPairs(scene);
  std::vector<bool> stale(summary.objects);
  const auto watch = [&] {
    for (std::size_t i = 0; i < stale.size(); ++i) {
      const PoseState s = scene.objects()[i].pose_state;
      if (s == PoseState::kStale || s == PoseState::kRejected) stale[i] = true;
    }
  };

  // The first cycle sets sizes and first-time caches; it is run once more as a frame.
  session.step(times.front());
  for (const PairId id : all) results[id.index()] = scene.result(id);
  CycleStatistics statistics(1e-6 * RunSummary::kPeriodUs);
  if (options.profile && options.mode == RunMode::kLockstep)
    summary.profile.emplace(1e-6 * RunSummary::kPeriodUs);
  for (int repeat = 0; repeat < options.repeat && !summary.interrupted; ++repeat) {
    const bool last = repeat + 1 == options.repeat;
    if (react && options.mode == RunMode::kLockstep) {
      ClosedLoop loop(session, times.front());
      summary.cycles = 0;
      runFrames(session, &loop, times, options, last, summary, statistics, results, all, scene.renewed(),
                [&](double t, const auto& done) {
                  // The cycle nearest to the frame is the last one before it.
                  while (loop.time() <= t + 0.5 * ClosedLoop::kStep) {
                    const double at = loop.time();
                    if (summary.profile) summary.profile->begin();
                    const auto begin = Clock::now();
                    loop.step();
                    for (const PairId id : scene.renewed()) results[id.index()] = scene.result(id);
                    watch();
                    const double worked = seconds(Clock::now() - begin);
                    if (summary.profile) summary.profile->end(worked);
                    add(scene.counts(), summary.work);
                    ++summary.cycles;
                    done(at, worked);
                  }
                });
      summary.robots = reportOf(loop);
    } else if (options.mode == RunMode::kLockstep) {
      runFrames(session, nullptr, times, options, last, summary, statistics, results, all, scene.renewed(),
                [&](double t, const auto& done) {
                  if (summary.profile) summary.profile->begin();
                  const auto begin = Clock::now();
                  session.step(t);
                  for (const PairId id : scene.renewed()) results[id.index()] = scene.result(id);
                  watch();
                  const double worked = seconds(Clock::now() - begin);
                  if (summary.profile) summary.profile->end(worked);
                  add(scene.counts(), summary.work);
                  done(t, worked);
                });
    } else if (react) {
      LiveLoop live(session, times.front(), liveGroups(session));
      summary.cycles = 0;
      runFrames(session, &live.loop(), times, options, last, summary, statistics, results, all, all,
                [&](double t, const auto& done) {
                  while (live.loop().time() <= t + 0.5 * ClosedLoop::kStep) {
                    const double at = live.loop().time();
                    const double worked = live.cycle(results);
                    watch();
                    ++summary.cycles;
                    done(at, worked);
                  }
                });
      add(live.counts(), summary.work);
      summary.robots = reportOf(live.loop());
    } else {
      PairThreads threads(scene);
      for (auto& group : liveGroups(session)) threads.start(threads.addGroup(std::move(group)));
      const double period =
          times.size() > 1 ? (times.back() - times.front()) / static_cast<double>(times.size() - 1) : 0.001;
      Pacer pacer{std::chrono::nanoseconds(static_cast<long>(period * 1e9))};
      runFrames(session, nullptr, times, options, last, summary, statistics, results, all, all,
                [&](double t, const auto& done) {
                  auto begin = Clock::now();
                  session.applyMotion(t);
                  threads.publishPoses(scene);
                  const double worked = seconds(Clock::now() - begin);
                  // The groups have the rest of the period for these poses.
                  pacer.wait();
                  begin = Clock::now();
                  threads.collect(results);
                  watch();
                  done(t, worked + seconds(Clock::now() - begin));
                });
      add(threads.counts(), summary.work);
    }
  }
  summary.median_us = 1e6 * statistics.median();
  summary.p99_us = 1e6 * statistics.p99();
  summary.p999_us = 1e6 * statistics.p999();
  summary.max_us = 1e6 * statistics.max();
  summary.overruns = statistics.overruns();
  for (const SpeedBreach& b : scene.speedWatch().listed())
    summary.breaches.push_back({scene.object(b.object).spec.name, b.t, b.speed, b.bound});
  summary.breach_count = scene.speedWatch().count();
  for (std::size_t i = 0; i < stale.size(); ++i)
    if (stale[i]) summary.stale.push_back(scene.objects()[i].spec.name);
  return summary;
}

}  // namespace abstand
