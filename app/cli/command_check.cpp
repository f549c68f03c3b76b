// abstand check: distance check for scripts.
#include <algorithm>
#include <iostream>

#include "app/cli/command_line.hpp"
#include "app/cli/cut_things.hpp"
#include "app/cli/reservation_texts.hpp"
#include "app/cli/robot_texts.hpp"
#include "app/cli/warm_start.hpp"
#include "app/depth/open_session.hpp"
#include "app/run/check_report.hpp"
#include "app/run/distance_check.hpp"
#include "app/run/run_scene.hpp"
#include "core/base/error.hpp"
#include "core/base/interrupt.hpp"
#include "core/base/standard_output.hpp"

namespace abstand::cli {
namespace {

struct CheckArguments {
  std::string scene, min_distance, margins, junit, report;
  std::vector<std::string> recordings;
  std::string poses, react{"on"};
  WarmStartArguments warm_start;
  bool dry_run{false}, strict{false}, swept{false};
  std::optional<bool> cut_things;
  robot_file::PackagePaths packages;
};

int dryRun(const CommandLine& line, const scene_file::SceneDescription& scene) {
  for (const auto& remark : scene.remarks) line.warn(remark);
  const std::string text = scene_file::describeScene(scene);
  // A file that is read back, not a report: written without any change.
  if (line.json)
    line.print({{"passed", true}, {"scene", text}}, "");
  else if (!line.quiet)
    writeStandardOutput(text);
  return kDone;
}

nlohmann::ordered_json violationJson(const run::Violation& v) {
  nlohmann::ordered_json j{
      {"a", v.a},        {"b", v.b}, {"start", v.start}, {"end", v.end}, {"min_distance", v.min_distance},
      {"limit", v.limit}};
  if (v.uncertainty > 0.0) j["reach"] = v.uncertainty;  // null: a body was not seen at all
  if (!v.recording.empty()) j["recording"] = v.recording;
  return j;
}

/// Text for the amount by which a limit was widened; empty: none.
std::string widened(double uncertainty) {
  if (!(uncertainty > 0.0)) return {};
  if (std::isinf(uncertainty)) return "; one of them was never tracked";
  return format(", plus %.1f mm of pose uncertainty", 1e3 * uncertainty);
}

/// "2 limits violated, 1 reservation (refused_pose)".
std::string whyNot(const run::CheckResult& result, bool strict) {
  const auto counted = [](std::size_t n, const char* one, const char* many) {
    return std::to_string(n) + " " + (n == 1 ? one : many);
  };
  std::string text;
  const auto add = [&](const std::string& reason) { text += (text.empty() ? "" : ", ") + reason; };
  if (!result.violations.empty()) add(counted(result.violations.size(), "limit violated", "limits violated"));
  if (strict && !result.unproven.empty())
    add(counted(result.unproven.size(), "pair not proven", "pairs not proven"));
  std::string kinds;
  std::size_t failed = 0;
  for (const run::Reservation& r : result.reservations) {
    if (!run::failing(r, strict)) continue;
    ++failed;
    if (kinds.find(r.kind) == std::string::npos) kinds += (kinds.empty() ? "" : ", ") + r.kind;
  }
  if (failed > 0) add(counted(failed, "reservation", "reservations") + " (" + kinds + ")");
  return text;
}

/// Everything checked, over the recordings.
struct Judged {
  run::CheckResult all;
  nlohmann::ordered_json reactions = nlohmann::ordered_json::array();
  nlohmann::ordered_json joint_limits = nlohmann::ordered_json::array();
  nlohmann::ordered_json warm_start;
  std::vector<std::string> remarks;  ///< of the sessions, each once
  std::string robots_text;
  bool interrupted{false};
};

void judge(const CommandLine& line, const CheckArguments& args, const scene_file::SceneDescription& scene,
           double limit, const std::string& recording, Judged& judged) {
  session::SessionOptions options;
  options.recording = recording;
  options.cut_things = args.cut_things;
  options.poses = args.poses;
  options.cache = line.cache;
  options.monitor = buildMonitor(line);
  args.warm_start.apply(options);
  // The check disables culling, whatever the scene allows.
  options.rest = 0.0;
  options.horizon = options.budget = kInfinity;
  const auto opened = depth::openSession(scene, options);
  session::Session& session = *opened;
  if (!args.margins.empty()) run::applyMargins(session.scene(), args.margins);
  run::DistanceCheck check(session.scene(), limit, !args.margins.empty(), args.swept, recording);
  run::RunOptions run;
  run.progress = progressBar(line, recording.empty() ? "check" : recording);
  run.interrupted = interrupted;
  run.react = args.react == "on";
  run.on_cycle = [&](double t, const std::vector<query::PairResult>& results) { check.frame(t, results); };
  const run::RunSummary summary = run::runScene(session, run);
  check.finish(summary, judged.all);
  judged.warm_start = warmStartJson(summary.warm_start);
  if (summary.cycles > 0) {
    judged.reactions.push_back({{"recording", recording}, {"robots", robotsJson(summary.robots)}});
    judged.robots_text += (args.recordings.size() > 1 ? recording + ":\n" : "") + robotsText(summary.robots);
  }
  for (auto& j : jointLimitsJson(summary.joint_limits)) {
    if (!recording.empty()) j["recording"] = recording;
    judged.joint_limits.push_back(std::move(j));
  }
  for (const std::string& remark : session.remarks())
    if (std::find(judged.remarks.begin(), judged.remarks.end(), remark) == judged.remarks.end())
      judged.remarks.push_back(remark);
  judged.interrupted = summary.interrupted;
}

/// If interrupted, the check fails, and the results so far are reported.
Judged judgeAll(const CommandLine& line, const CheckArguments& args,
                const scene_file::SceneDescription& scene, double limit) {
  Judged judged;
  std::vector<std::string> recordings = args.recordings;
  if (recordings.empty()) recordings.emplace_back();
  for (const auto& recording : recordings) {
    bool begun = !judged.interrupted;
    if (begun) {
      try {
        judge(line, args, scene, limit, recording, judged);
      } catch (const structure::BuildCancelled&) {
        begun = false;
      } catch (const Interrupted&) {
        begun = false;
      }
    }
    if (begun) continue;
    judged.interrupted = true;
    run::Reservation r = run::interruptedReservation(0, 0, {});
    r.recording = recording;
    run::addReservations(judged.all.reservations, {r});
  }
  return judged;
}

int runCheck(const CommandLine& line, const CheckArguments& args) {
  const scene_file::SceneDescription scene = scene_file::loadScene(args.scene, args.packages);
  if (args.dry_run) return dryRun(line, scene);
  if (args.min_distance.empty()) throw UsageError("--min-distance is required (or --dry-run)");
  const double limit = number(args.min_distance, "--min-distance");
  const Judged judged = judgeAll(line, args, scene, limit);
  const run::CheckResult& all = judged.all;
  const bool ok = run::passed(all, args.strict);
  nlohmann::ordered_json document{{"passed", ok}, {"min_distance_limit", limit}, {"frames", all.frames}};
  document["min_distance"] = extremeJson(all.min_distance);
  document["min_distance_by_class"] = byClassJson(all.min_distance_by_class);
  std::string text = closestText(all.min_distance_by_class);
  for (const auto* list : {&all.violations, &all.unproven}) {
    auto rows = nlohmann::ordered_json::array();
    for (const run::Violation& v : *list) {
      rows.push_back(violationJson(v));
      text += format("%s: %s to %s, %.3f s to %.3f s, %.1f mm (limit %.1f mm%s)\n",
                     list == &all.violations ? "violated" : "not proven", v.a.c_str(), v.b.c_str(), v.start,
                     v.end, 1e3 * v.min_distance, 1e3 * v.limit, widened(v.uncertainty).c_str());
    }
    document[list == &all.violations ? "violations" : "unproven"] = rows;
  }
  document["warm_start"] = judged.warm_start;
  document["reservations"] = reservationsJson(all.reservations);
  document["stale"] = all.stale;
  if (args.swept) document["swept"] = {{"queries", all.swept_queries}};
  if (!judged.reactions.empty()) document["reactions"] = judged.reactions;
  document["joint_limits"] = judged.joint_limits;
  document["remarks"] = judged.remarks;
  document["interrupted"] = judged.interrupted;
  text += judged.robots_text;
  text += reservationsText(all.reservations) +
          (ok ? "passed\n" : "not passed: " + whyNot(all, args.strict) + "\n");
  if (!args.junit.empty()) run::writeJunit(all, args.scene, args.strict, args.junit);
  if (!args.report.empty()) run::writeHtmlReport(all, args.scene, limit, args.strict, args.report);
  line.print(document, text);
  if (judged.interrupted) return kInterrupted;
  return ok ? kDone : kLimitBroken;
}

}  // namespace

void addCheck(CLI::App& root, CommandLine& line) {
  auto* command =
      addCommand(root, line, "check", "checks distance limits for scripts: exit 1 if a limit is violated",
                 "abstand check cell.yaml --recording reach.bvh --min-distance 0.1 --junit result.xml");
  auto args = std::make_shared<CheckArguments>();
  command->add_option("SCENE", args->scene, "scene file")->required();
  command->add_option("--recording", args->recordings, "recordings, each checked in turn");
  addCutThings(*command, args->cut_things);
  command->add_option("--poses", args->poses,
                      "CSV of poses, or recorded moments of a server, that named objects follow");
  command->add_option("--min-distance", args->min_distance, "smallest distance allowed, m");
  command->add_option("--margins", args->margins,
                      "YAML, NAME: metres; the limit of a pair is then also the sum of its margins");
  line.output(command->add_option("--junit", args->junit, "JUnit XML"));
  line.output(command->add_option("--report", args->report, "HTML page"));
  command
      ->add_option("--react", args->react,
                   "on: mechanisms with a reaction react, and every millisecond is checked; off: they "
                   "follow their planned motion")
      ->check(CLI::IsMember({"on", "off"}));
  command->add_flag("--dry-run", args->dry_run, "print the scene as parsed, without running it");
  command->add_flag("--strict", args->strict,
                    "also fail if distance minus error bound is below the limit, and for every "
                    "reservation that affects safety (guessed units, open meshes, gaps, ...)");
  command->add_flag("--swept", args->swept,
                    "also check between frames: certified for bodies that move linearly from pose to pose");
  addWarmStart(*command, args->warm_start);
  addPackagePath(command, args->packages);
  addCacheFlag(command, line);
  command->callback([&line, args] { line.run = [&line, args] { return runCheck(line, *args); }; });
}

}  // namespace abstand::cli
