#include "app/run/run_scene.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

#include "app/run/cold_query.hpp"
#include "app/run/pose_watch.hpp"
#include "app/run/session_log.hpp"
#include "app/session/times_between.hpp"
#include "core/base/error.hpp"
#include "core/base/pacer.hpp"
#include "core/scene/cycle_statistics.hpp"
#include "core/scene/pair_threads.hpp"

namespace abstand::run {
namespace {

using Clock = std::chrono::steady_clock;

double seconds(Clock::duration d) { return std::chrono::duration<double>(d).count(); }

/// The frames of a pass, and where they stand among all.
struct Frames {
  std::vector<double> times;  ///< s
  /// s, of all frames before them: velocities follow from the last poses, and the poser's choices among equal
  /// poses from all.
  std::vector<double> before;
  std::size_t first{0};
};

Frames framesOf(const session::Session& session, const RunOptions& options) {
  const std::vector<double> all = options.rate ? session.frameTimes(*options.rate) : session.frameTimes();
  Frames frames;
  frames.times = session::timesBetween(all, options.start, options.end);
  const auto at = std::find(all.begin(), all.end(), frames.times.front());
  frames.first = static_cast<std::size_t>(at - all.begin());
  frames.before.assign(all.begin(), at);
  return frames;
}

/// Collects what a frame says of the extremes.
class Extremes {
 public:
  explicit Extremes(const session::Session& session)
      : session_(session), touching_(session.scene().pairs().size(), false), classes_(pairClasses(session)) {}

  /// `renewed`: the pairs whose results may differ from the last frame's; all of them in the first frame.
  void frame(double t, const std::vector<query::PairResult>& results, const std::vector<PairId>& renewed,
             RunSummary& summary) {
    for (const PairId id : renewed) {
      const std::size_t i = id.index();
      const query::PairResult& r = results[i];
      const double age = session_.scene().ageOf(id, t);
      if (age > age_ || (age == age_ && t == age_t_ && i < age_pair_)) {
        age_ = age;
        age_pair_ = i;
        age_t_ = t;
      }
      distance_.offer(r.distance, t, i);
      if (classes_[i] != PairClass::kOther)
        least_[static_cast<std::size_t>(classes_[i])].offer(r.distance, t, i);
      lookAtClearance(id, t, r.distance);
      const double force = r.force_a.norm();
      if (force > force_ || (force == force_ && t == force_t_ && i < force_pair_)) {
        force_ = force;
        force_pair_ = i;
        force_t_ = t;
        force_apart_ = r.distance > 0.0;
      }
      const bool touches = r.contacts > 0;
      if (touches != touching_[i]) touching_count_ += touches ? 1 : -1;
      touching_[i] = touches;
    }
    summary.contacts += touching_count_;
    // What is not seen comes nearer although nothing was renewed.
    const scene::Scene& scene = session_.scene();
    for (std::uint32_t i = 0; i < scene.objectCount(); ++i)
      if (scene.object(ObjectId(i)).reach > 0.0)
        for (const PairId id : scene.pairsOf(ObjectId(i)))
          lookAtClearance(id, t, results[id.index()].distance);
  }

  void finish(RunSummary& summary, RunMode mode) const {
    if (mode == RunMode::kLive && age_ >= 0.0) summary.oldest_result = extreme(age_pair_, age_t_, age_);
    summary.min_distance = extreme(distance_);
    for (std::size_t i = 0; i < least_.size(); ++i) summary.min_distance_by_class[i] = extreme(least_[i]);
    summary.min_clearance = extreme(clearance_);
    summary.peak_force_apart = force_apart_;
    if (force_ > 0.0) summary.peak_force = extreme(force_pair_, force_t_, force_);
  }

  RunSummary::Extreme extreme(std::size_t pair, double t, double value) const {
    const scene::Scene& scene = session_.scene();
    const scene::Pair& p = scene.pairs()[pair];
    return {scene.object(p.a).spec.name, scene.object(p.b).spec.name, t, value};
  }

 private:
  /// The least distance of some pairs, m; of equal ones at a time the first in scene order, whatever the
  /// order in which they are offered.
  struct Least {
    double value{kInfinity}, t{0.0};
    std::size_t pair{0};
    void offer(double d, double at, std::size_t i) {
      if (d < value || (d == value && at == t && i < pair)) *this = {d, at, i};
    }
  };
  std::optional<RunSummary::Extreme> extreme(const Least& least) const {
    if (!(least.value < kInfinity)) return {};
    return extreme(least.pair, least.t, least.value);
  }
  void lookAtClearance(PairId id, double t, double distance) {
    clearance_.offer(distance - session_.scene().pairUncertainty(id), t, id.index());
  }

  const session::Session& session_;
  std::vector<bool> touching_;
  long touching_count_{0};
  Least distance_, clearance_;
  double force_{0.0}, force_t_{0.0};
  bool force_apart_{false};
  std::vector<PairClass> classes_;
  std::array<Least, kPairClasses.size()> least_;
  double age_{-1.0}, age_t_{0.0};
  std::size_t force_pair_{0}, age_pair_{0};
};

/// Times one pair a frame, in turn, outside the measured cycle.
class PairClock {
 public:
  explicit PairClock(const scene::Scene& scene)
      : sum_us_(scene.pairs().size()), count_(scene.pairs().size()) {}

  void sample(const scene::Scene& scene) {
    if (sum_us_.empty()) return;
    const auto begin = Clock::now();
    result_ = queryCold(scene, scene.pairs()[next_], scratch_);
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
  kernels::PairScratch scratch_;
  query::PairResult result_;
};

/// The groups of pairs that live mode runs: the scene file's with one for the rest, or one group a core.
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

void add(const scene::StepCounts& counts, RunSummary::Work& work) {
  work.checked += counts.checked;
  work.rested += counts.rested;
  work.beyond += counts.beyond;
  work.put_off += counts.put_off;
  work.longest_wait = std::max(work.longest_wait, counts.longest_wait);
}

std::vector<PairId> allPairs(const scene::Scene& scene) {
  std::vector<PairId> all;
  for (std::uint32_t i = 0; i < scene.pairs().size(); ++i) all.emplace_back(i);
  return all;
}

/// Cycles of one run over all frames; lock step, live and the closed loop differ only in `cycle`, which says
/// of each cycle up to a frame when it was and how many seconds it worked, and in `renewed`, the pairs whose
/// results a cycle may have changed.
template <class Cycle>
void runFrames(const session::Session& session, const loop::ClosedLoop* loop,
               const std::vector<double>& times, const RunOptions& options, bool last, RunSummary& summary,
               scene::CycleStatistics& statistics, std::vector<query::PairResult>& results,
               const std::vector<PairId>& all, const std::vector<PairId>& renewed, Cycle cycle) {
  const bool live = options.mode == RunMode::kLive;
  CsvOutputs csv(last ? options.csv : CsvPaths{}, session, loop, live);
  std::unique_ptr<SessionLog> log;
  if (last && !options.session_log.empty())
    log = std::make_unique<SessionLog>(options.session_log, session, live);
  Extremes extremes(session);
  PairClock pair_clock(session.scene());
  PoseWatch poses(session);
  summary.contacts = 0;
  summary.frames = 0;
  bool first = true;
  double shown = 0.0;  // s, of the last cycle
  const auto done = [&](double t, double worked) {
    shown = t;
    statistics.add(worked);
    extremes.frame(t, results, first ? all : renewed, summary);
    poses.cycle(t);
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
    csv.write(t, shown, session, results);
    if (log) log->write(t, shown, session, results);
    ++summary.frames;
    if (options.progress) options.progress(summary.frames, times.size());
  }
  extremes.finish(summary, options.mode);
  pair_clock.finish(extremes, summary);
  summary.reservations = reservationsOf(session);
  addReservations(summary.reservations, poses.reservations());
  // Nothing is said of the time after an interrupt.
  std::optional<double> last_frame;
  if (summary.frames > 0) last_frame = times[summary.frames - 1];
  if (summary.interrupted)
    summary.reservations.push_back(interruptedReservation(summary.frames, times.size(), last_frame));
  summary.joint_limits = jointLimitsOf(session, loop, times.front(), last_frame.value_or(times.front()));
  addReservations(summary.reservations, reservationsOf(summary.joint_limits));
  csv.finish();
  if (log) log->finish();
  csv.commit();
  if (log) log->commit();
}

}  // namespace

RunSummary runScene(session::Session& session, const RunOptions& options) {
  const bool react = options.react && session.reacts();
  const Frames frames = framesOf(session, options);
  const std::vector<double>& times = frames.times;
  scene::Scene& scene = session.scene();
  RunSummary summary;
  summary.objects = scene.objectCount();
  summary.pairs = scene.pairs().size();
  summary.build_ms = session.buildMs();
  summary.memory_bytes = scene.memoryBytes();
  std::vector<query::PairResult> results(summary.pairs);
  const std::vector<PairId> all = allPairs(scene);
  std::vector<bool> stale(summary.objects);
  const auto watch = [&] {
    for (std::size_t i = 0; i < stale.size(); ++i) {
      const scene::PoseState s = scene.objects()[i].pose_state;
      if (s == scene::PoseState::kStale || s == scene::PoseState::kRejected) stale[i] = true;
    }
  };

  const bool passes = options.mode == RunMode::kLockstep && !react;
  // The first cycle sets sizes and first-time caches; it is run once more as a frame, or before those of a
  // pass that begins later.
  session.step(passes && !frames.before.empty() ? frames.before.front() : times.front());
  if (passes)
    for (const double t : frames.before) session.applyMotion(t);
  const long breaches_before = scene.speedWatch().count();
  if (scene.culling().remember && options.mode == RunMode::kLockstep)
    summary.warm_start = {passes ? kColdStart : 0, scene.culling().far_tolerance};
  for (const PairId id : all) results[id.index()] = scene.result(id);
  scene::CycleStatistics statistics(1e-6 * RunSummary::kPeriodUs);
  if (options.profile && options.mode == RunMode::kLockstep)
    summary.profile.emplace(1e-6 * RunSummary::kPeriodUs);
  for (int repeat = 0; repeat < options.repeat && !summary.interrupted; ++repeat) {
    const bool last = repeat + 1 == options.repeat;
    scene.startCold();
    if (react && options.mode == RunMode::kLockstep) {
      loop::ClosedLoop loop(session, times.front());
      summary.cycles = 0;
      runFrames(session, &loop, times, options, last, summary, statistics, results, all, scene.renewed(),
                [&](double t, const auto& done) {
                  // The cycle nearest to the frame is the last one before it.
                  while (loop.time() <= t + 0.5 * loop::ClosedLoop::kStep) {
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
      summary.robots = loop::reportOf(loop);
    } else if (options.mode == RunMode::kLockstep) {
      std::size_t frame = frames.first;
      runFrames(session, nullptr, times, options, last, summary, statistics, results, all, scene.renewed(),
                [&](double t, const auto& done) {
                  if (summary.profile) summary.profile->begin();
                  const auto begin = Clock::now();
                  if (frame++ % kColdStart == 0) scene.startCold();
                  session.step(t);
                  for (const PairId id : scene.renewed()) results[id.index()] = scene.result(id);
                  watch();
                  const double worked = seconds(Clock::now() - begin);
                  if (summary.profile) summary.profile->end(worked);
                  add(scene.counts(), summary.work);
                  done(t, worked);
                });
    } else if (react) {
      LiveLoop live(session, times.front(), liveGroups(session), options.pace);
      summary.cycles = 0;
      runFrames(session, &live.loop(), times, options, last, summary, statistics, results, all, all,
                [&](double t, const auto& done) {
                  while (live.loop().time() <= t + 0.5 * loop::ClosedLoop::kStep) {
                    const double at = live.loop().time();
                    const double worked = live.cycle(results);
                    watch();
                    ++summary.cycles;
                    done(at, worked);
                  }
                });
      add(live.counts(), summary.work);
      summary.robots = loop::reportOf(live.loop());
    } else {
      session.applyMotion(times.front());
      scene::PairThreads threads(scene);
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
                  if (options.pace == LivePace::kRealTime) pacer.wait();
                  begin = Clock::now();
                  if (options.pace == LivePace::kRealTime)
                    threads.collect(results);
                  else
                    settle(threads, results);
                  scene.take(results, threads.resultTimes());
                  session.sumEfforts();
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
  for (const scene::SpeedBreach& b : scene.speedWatch().listed())
    if (b.t >= times.front())
      summary.breaches.push_back({scene.object(b.object).spec.name, b.t, b.speed, b.bound});
  summary.breach_count = scene.speedWatch().count() - breaches_before;
  for (std::size_t i = 0; i < stale.size(); ++i)
    if (stale[i]) summary.stale.push_back(scene.objects()[i].spec.name);
  return summary;
}

}  // namespace abstand::run
