// abstand run: runs a scene over its motion.
#include <algorithm>

#include "app/cli/command_line.hpp"
#include "app/cli/cut_things.hpp"
#include "app/cli/reservation_texts.hpp"
#include "app/cli/robot_texts.hpp"
#include "app/cli/version.hpp"
#include "app/cli/warm_start.hpp"
#include "app/depth/open_session.hpp"
#include "app/run/run_scene.hpp"
#include "core/base/error.hpp"

namespace abstand::cli {
namespace {

struct RunArguments {
  std::string scene, start, end, rate, rest, horizon, budget, mode{"lockstep"}, react{"on"};
  std::string gain, person_speed;
  session::SessionOptions session;
  WarmStartArguments warm_start;
  run::RunOptions run;
  robot_file::PackagePaths packages;
};

nlohmann::ordered_json skippingJson(const run::RunSummary& s) {
  auto breaches = nlohmann::ordered_json::array();
  for (const auto& b : s.breaches.listed)
    breaches.push_back({{"object", b.object}, {"t", b.t}, {"speed", b.speed}, {"bound", b.bound}});
  return {{"checked", s.work.checked},
          {"rested", s.work.rested},
          {"beyond_horizon", s.work.beyond},
          {"put_off", s.work.deferred},
          {"longest_wait_cycles", s.work.longest_wait},
          {"breach_count", s.breaches.count},
          {"breaches", breaches}};
}

nlohmann::ordered_json timesJson(const scene::CycleStatistics& s) {
  return {{"median", 1e6 * s.median()},
          {"p99", 1e6 * s.p99()},
          {"p999", 1e6 * s.p999()},
          {"max", 1e6 * s.max()},
          {"overruns", s.overruns()}};
}

nlohmann::ordered_json summaryJson(const run::RunSummary& s, const session::Session& session) {
  nlohmann::ordered_json j{{"frames", s.frames},
                           {"objects", s.objects},
                           {"pairs", s.pairs},
                           {"cycle_us",
                            {{"median", s.cycle_us.median},
                             {"p99", s.cycle_us.p99},
                             {"p999", s.cycle_us.p999},
                             {"max", s.cycle_us.max}}},
                           {"overruns", s.cycle_us.overruns},
                           {"period_us", run::RunSummary::kPeriodUs},
                           {"min_distance", extremeJson(s.min_distance)},
                           {"min_distance_by_class", byClassJson(s.min_distance_by_class)},
                           {"min_clearance", extremeJson(s.min_clearance)},
                           {"contacts", s.contacts},
                           {"peak_force", s.peak_force ? s.peak_force->value : 0.0},
                           {"peak_force_at", extremeJson(s.peak_force)}};
  if (s.peak_force) j["peak_force_at"]["virtual"] = s.peak_force_apart;
  j["oldest_result"] = extremeJson(s.oldest_result);
  j["slowest_pair"] = nullptr;
  if (s.slowest_pair)
    j["slowest_pair"] = {
        {"a", s.slowest_pair->a}, {"b", s.slowest_pair->b}, {"mean_us", s.slowest_pair->value}};
  if (s.profile)
    j["profile_us"] = {{"processor", timesJson(s.profile->work())},
                       {"empty", timesJson(s.profile->empty())},
                       {"empty_processor", timesJson(s.profile->emptyWork())}};
  j["skipping"] = skippingJson(s);
  j["warm_start"] = warmStartJson(s.warm_start);
  if (s.cycles > 0) {
    j["cycles"] = s.cycles;
    j["robots"] = robotsJson(s.robots);
  }
  j["joint_limits"] = jointLimitsJson(s.joint_limits);
  j["build_ms"] = s.build_ms;
  j["cached_structures"] = session.cachedStructures();
  j["memory_bytes"] = s.memory_bytes;
  j["stale"] = s.stale;
  j["reservations"] = reservationsJson(s.reservations);
  j["remarks"] = session.remarks();
  j["interrupted"] = s.interrupted;
  return j;
}

std::string timesText(const char* what, const scene::CycleStatistics& s) {
  return format("%s: median %.0f us, p99 %.0f, p99.9 %.0f, max %.0f; %ld above 1 ms\n", what,
                1e6 * s.median(), 1e6 * s.p99(), 1e6 * s.p999(), 1e6 * s.max(), s.overruns());
}

std::string summaryText(const run::RunSummary& s, const session::Session& session) {
  std::string text = format("%zu frames, %zu objects, %zu pairs; structures %.0f ms, %.1f MB\n", s.frames,
                            s.objects, s.pairs, s.build_ms, static_cast<double>(s.memory_bytes) * 1e-6);
  if (s.cycles > 0) text += format("closed loop: %ld cycles of 1 ms\n", s.cycles);
  text += format("cycle: median %.0f us, p99 %.0f, p99.9 %.0f, max %.0f; %ld above 1 ms\n", s.cycle_us.median,
                 s.cycle_us.p99, s.cycle_us.p999, s.cycle_us.max, s.cycle_us.overruns);
  if (s.profile)
    text += timesText("  processor time", s.profile->work()) +
            timesText("  empty loop of the same length", s.profile->empty()) +
            timesText("  processor time", s.profile->emptyWork());
  text += warmStartText(s.warm_start);
  text += closestText(s.min_distance_by_class);
  if (s.min_distance)
    text += format("minimum distance: %.1f mm, %s to %s at %.3f s\n", 1e3 * s.min_distance->value,
                   s.min_distance->a.c_str(), s.min_distance->b.c_str(), s.min_distance->t);
  if (s.min_clearance && s.min_clearance->value == -kInfinity)
    text += format("smallest clearance including pose uncertainty: unknown, %s or %s was never tracked\n",
                   s.min_clearance->a.c_str(), s.min_clearance->b.c_str());
  else if (s.min_clearance && s.min_distance && s.min_clearance->value < s.min_distance->value)
    text += format("smallest clearance including pose uncertainty: %.1f mm, %s to %s at %.3f s\n",
                   1e3 * s.min_clearance->value, s.min_clearance->a.c_str(), s.min_clearance->b.c_str(),
                   s.min_clearance->t);
  if (s.peak_force)
    text += format("peak %s: %.2f N, %s on %s at %.3f s; %ld pair contacts in all frames\n",
                   s.peak_force_apart ? "virtual (margin) force" : "force", s.peak_force->value,
                   s.peak_force->b.c_str(), s.peak_force->a.c_str(), s.peak_force->t, s.contacts);
  if (s.oldest_result)
    text += format("oldest result: %.1f ms, %s to %s at %.3f s\n", 1e3 * s.oldest_result->value,
                   s.oldest_result->a.c_str(), s.oldest_result->b.c_str(), s.oldest_result->t);
  text += robotsText(s.robots);
  if (s.work.rested + s.work.beyond + s.work.deferred > 0)
    text +=
        format("pair queries in all cycles: %ld queried, %ld culled, %ld beyond the horizon, %ld deferred\n",
               s.work.checked, s.work.rested, s.work.beyond, s.work.deferred);
  if (s.breaches.count > 0)
    text += format("max_speed exceeded: %s at %.3f s, %.2f m/s (limit %.2f); %ld times in all\n",
                   s.breaches.listed.front().object.c_str(), s.breaches.listed.front().t,
                   s.breaches.listed.front().speed, s.breaches.listed.front().bound, s.breaches.count);
  for (const auto& remark : session.remarks())
    if (std::none_of(s.reservations.begin(), s.reservations.end(),
                     [&](const run::Reservation& r) { return r.text == remark; }))
      text += remark + "\n";
  text += reservationsText(s.reservations);
  return text;
}

int runRun(const CommandLine& line, RunArguments& args) {
  if (!args.start.empty()) args.run.start = number(args.start, "--start");
  if (!args.end.empty()) args.run.end = number(args.end, "--end");
  if (!args.rate.empty()) {
    args.run.rate = number(args.rate, "--rate");
    if (*args.run.rate < 0.001 || *args.run.rate > 1e6)
      throw UsageError("--rate: found " + args.rate + ", expected 0.001 to 1000000 Hz");
  }
  if (!args.rest.empty()) args.session.rest = number(args.rest, "--rest");
  if (!args.horizon.empty()) args.session.horizon = number(args.horizon, "--horizon");
  if (!args.budget.empty()) args.session.budget = number(args.budget, "--budget");
  args.warm_start.apply(args.session);
  args.run.react = args.react == "on";
  args.run.mode = args.mode == "live" ? run::RunMode::kLive : run::RunMode::kLockstep;
  args.run.progress = progressBar(line, "run");
  args.run.interrupted = interrupted;
  args.run.program = kVersion;
  args.session.cache = line.cache;
  args.session.monitor = buildMonitor(line);
  if (!args.person_speed.empty())
    args.session.person_speed = numberWithin(args.person_speed, "--person-speed", 0.01, 100.0, "");
  scene_file::SceneDescription scene = scene_file::loadScene(args.scene, args.packages);
  if (!args.gain.empty()) {
    const double gain = numberWithin(args.gain, "--gain", 0.0, 100.0, "");
    for (auto& m : scene.mechanisms)
      if (m.reaction) control::scaleGains(*m.reaction, gain);
  }
  const auto opened = depth::openSession(std::move(scene), args.session);
  session::Session& session = *opened;
  const run::RunSummary summary = run::runScene(session, args.run);
  line.print(summaryJson(summary, session), summaryText(summary, session));
  return summary.interrupted ? kInterrupted : kDone;
}

}  // namespace

void addRun(CLI::App& root, CommandLine& line) {
  auto* command =
      addCommand(root, line, "run", "runs a scene over its motion: distances, forces, joint efforts",
                 "abstand run data/scenes/hug_boxing.yaml --json --pairs-out pairs.csv");
  auto args = std::make_shared<RunArguments>();
  command->add_option("SCENE", args->scene, "scene file")->required();
  addCutThings(*command, args->session.cut_things);
  command->add_option("--poses", args->session.poses,
                      "CSV of poses, or recorded moments of a server, that named objects follow");
  command->add_option("--recording", args->session.recording, "recording that replaces the scene's");
  command->add_option("--start", args->start, "first time in s");
  command->add_option("--end", args->end, "last time in s");
  command->add_option("--rate", args->rate, "frames per second (default: the rate of the recording)");
  command
      ->add_option("--threads", args->session.threads,
                   "lock-step threads (0: all cores; the results are bit-identical for any number)")
      ->check(CLI::Range(0, 256));
  command->add_option("--mode", args->mode, "lockstep or live (pair threads in real time)")
      ->check(CLI::IsMember({"lockstep", "live"}));
  command
      ->add_option(
          "--react", args->react,
          "on: mechanisms with a reaction react (closed loop); off: they follow their planned motion")
      ->check(CLI::IsMember({"on", "off"}));
  command->add_option("--gain", args->gain, "factor on the reaction forces, for what-if runs (0 to 100)");
  command->add_option("--person-speed", args->person_speed,
                      "factor on the speed of the recordings, for what-if runs (0.01 to 100)");
  command->add_option("--rest", args->rest,
                      "temporal culling: share of its clearance (0 to 1) that a pair may use up before it is "
                      "queried again (default: the scene's, else 0)");
  command->add_option("--horizon", args->horizon,
                      "m between bounding spheres beyond which a pair is not queried (lockstep)");
  command->add_option(
      "--budget", args->budget,
      "time budget of a cycle in s; further queries are deferred and their bounds grow (lockstep)");
  addWarmStart(*command, args->warm_start);
  line.output(command->add_option("--pairs-out", args->run.csv.pairs, "CSV, one row per frame and pair"));
  line.output(
      command->add_option("--objects-out", args->run.csv.objects, "CSV, one row per frame and object"));
  line.output(command->add_option("--joints-out", args->run.csv.joints, "CSV, one row per frame"));
  line.output(command->add_option("--cycles-out", args->run.csv.cycles,
                                  "CSV, one row per cycle: processing time and number of colliding pairs"));
  command
      ->add_option("--cycles-every", args->run.csv.cycles_every,
                   "--cycles-out writes every N-th cycle (default: 1)")
      ->check(CLI::Range(1, 1000000000));
  command->add_flag("--profile", args->run.profile,
                    "processor time of the cycles, and the delays of empty loops of the same length");
  line.output(
      command->add_option("--session", args->run.session_log, "HDF5 log of the run: docs/session-log.md"));
  command->add_option("--repeat", args->run.repeat, "number of repetitions, for timing")
      ->check(CLI::Range(1, 1000000));
  addPackagePath(command, args->packages);
  addCacheFlag(command, line);
  command->callback([&line, args] { line.run = [&line, args] { return runRun(line, *args); }; });
}

}  // namespace abstand::cli
