#include "app/run/run_scene.hpp"

#include <algorithm>

#include "app/run/cycle_source.hpp"
#include "app/run/extremes.hpp"
#include "app/run/pair_clock.hpp"
#include "app/run/pose_watch.hpp"
#include "app/run/session_log.hpp"
#include "app/session/times_between.hpp"
#include "core/base/error.hpp"
#include "core/scene/cycle_statistics.hpp"

namespace abstand::run {
namespace {

/// Frames of a pass, and of the time before it.
struct Frames {
  std::vector<double> times;  ///< s
  /// s, all earlier frames: run first, because velocities depend on the last poses, and the poser's choice
  /// among equal poses on all of them.
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

/// Adds reservations and violated robot limits to the summary.
void addJudgement(const PassState& state, const PoseWatch& poses, const CycleSource& source,
                  const std::vector<double>& times) {
  RunSummary& summary = state.summary;
  summary.reservations = reservationsOf(state.session);
  addReservations(summary.reservations, poses.reservations());
  // Nothing is stated about the time after an interrupt.
  std::optional<double> last_frame;
  if (summary.frames > 0) last_frame = times[summary.frames - 1];
  if (summary.interrupted)
    summary.reservations.push_back(interruptedReservation(summary.frames, times.size(), last_frame));
  summary.joint_limits =
      jointLimitsOf(state.session, source.loop(), times.front(), last_frame.value_or(times.front()));
  addReservations(summary.reservations, reservationsOf(summary.joint_limits));
}

/// One pass over the frames; the last pass writes the outputs.
void runFrames(PassState& state, CycleSource& source, const std::vector<double>& times, bool last,
               scene::CycleStatistics& statistics) {
  const session::Session& session = state.session;
  const RunOptions& options = state.options;
  RunSummary& summary = state.summary;
  const bool live = options.mode == RunMode::kLive;
  CsvOutputs csv(last ? options.csv : CsvPaths{}, session, source.loop(), live);
  std::unique_ptr<SessionLog> log;
  if (last && !options.session_log.empty())
    log = std::make_unique<SessionLog>(options.session_log, session, live, options.program);
  Extremes extremes(session);
  PairClock pair_clock(session.scene());
  PoseWatch poses(session);
  summary.contacts = 0;
  summary.frames = 0;
  bool first = true;
  double shown = 0.0;  // s, time of the last cycle
  const CycleSource::CycleDone done = [&](double t, double worked) {
    shown = t;
    statistics.add(worked);
    csv.addCycle(t, worked, state.results);
    if (options.extremes) extremes.frame(t, state.results, first ? state.all : source.updated(), summary);
    poses.cycle(t);
    if (last && options.on_cycle) options.on_cycle(t, state.results);
    first = false;
  };
  for (const double t : times) {
    if (options.interrupted && options.interrupted()) {
      summary.interrupted = true;
      break;
    }
    source.frame(t, done);
    if (options.extremes) pair_clock.sample(session.scene());
    csv.write(t, shown, session, state.results);
    if (log) log->write(t, shown, session, state.results);
    ++summary.frames;
    if (options.progress) options.progress(summary.frames, times.size());
  }
  extremes.finish(summary, options.mode);
  pair_clock.finish(extremes, summary);
  addJudgement(state, poses, source, times);
  csv.finish();
  if (log) log->finish();
  csv.commit();
  if (log) log->commit();
  source.finish();
}

/// The first cycle sets sizes and caches; it is run again as a frame, or before the frames of a pass that
/// starts later.
void runFirstCycle(session::Session& session, const Frames& frames, bool passes) {
  session.step(passes && !frames.before.empty() ? frames.before.front() : frames.times.front());
  if (passes)
    for (const double t : frames.before) session.applyMotion(t);
}

void addTimes(const scene::CycleStatistics& statistics, RunSummary& summary) {
  summary.cycle_us = {1e6 * statistics.median(), 1e6 * statistics.p99(), 1e6 * statistics.p999(),
                      1e6 * statistics.max(), statistics.overruns()};
}

void addBreaches(const scene::Scene& scene, double from, RunSummary& summary) {
  for (const scene::SpeedBreach& b : scene.speedWatch().listed())
    if (b.t >= from)
      summary.breaches.listed.push_back({scene.object(b.object).spec.name, b.t, b.speed, b.bound});
}

}  // namespace

RunSummary runScene(session::Session& session, const RunOptions& options) {
  const bool lock_step = options.mode == RunMode::kLockstep;
  const bool passes = lock_step && !(options.react && session.reacts());
  const Frames frames = framesOf(session, options);
  scene::Scene& scene = session.scene();
  RunSummary summary;
  summary.objects = scene.objectCount();
  summary.pairs = scene.pairs().size();
  summary.build_ms = session.buildMs();
  summary.memory_bytes = scene.memoryBytes();
  runFirstCycle(session, frames, passes);
  const long breaches_before = scene.speedWatch().count();
  if (scene.culling().remember && lock_step)
    summary.warm_start = {passes ? kColdStart : 0, scene.culling().far_tolerance};
  PassState state(session, options, summary);
  for (const PairId id : state.all) state.results[id.index()] = scene.result(id);
  scene::CycleStatistics statistics(1e-6 * RunSummary::kPeriodUs);
  if (options.profile && lock_step) summary.profile.emplace(1e-6 * RunSummary::kPeriodUs);
  for (int repeat = 0; repeat < options.repeat && !summary.interrupted; ++repeat) {
    scene.startCold();
    const auto source = makeCycleSource(state, frames.times, frames.first);
    runFrames(state, *source, frames.times, repeat + 1 == options.repeat, statistics);
  }
  addTimes(statistics, summary);
  addBreaches(scene, frames.times.front(), summary);
  summary.breaches.count = scene.speedWatch().count() - breaches_before;
  for (std::size_t i = 0; i < state.stale.size(); ++i)
    if (state.stale[i]) summary.stale.push_back(scene.objects()[i].spec.name);
  return summary;
}

}  // namespace abstand::run
