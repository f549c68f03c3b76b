// abstand check: the gate for scripts.
#include <iostream>

#include "app/cli/command_line.hpp"
#include "app/cli/robot_texts.hpp"
#include "app/run/check_report.hpp"
#include "app/run/distance_check.hpp"
#include "app/run/run_scene.hpp"
#include "core/base/error.hpp"

namespace abstand::cli {
namespace {

struct Arguments {
  std::string scene, min_distance, margins, junit, report;
  std::vector<std::string> recordings;
  std::string poses, react{"on"};
  bool dry_run{false}, strict{false}, swept{false}, cut_things{false};
  PackagePaths packages;
};

int dryRun(const CommandLine& line, const SceneDescription& scene) {
  const std::string text = describeScene(scene);
  line.print({{"passed", true}, {"scene", text}}, text);
  return kDone;
}

nlohmann::ordered_json violationJson(const Violation& v) {
  nlohmann::ordered_json j{
      {"a", v.a},        {"b", v.b}, {"start", v.start}, {"end", v.end}, {"min_distance", v.min_distance},
      {"limit", v.limit}};
  if (v.reach > 0.0) j["reach"] = v.reach;  // null: a body was not seen at all
  if (!v.recording.empty()) j["recording"] = v.recording;
  return j;
}

/// By how much a limit was widened, for people; empty: not at all.
std::string widened(double reach) {
  if (!(reach > 0.0)) return {};
  if (std::isinf(reach)) return ", but one of them was not seen at all";
  return format(", widened by %.1f mm for what is not known of their places", 1e3 * reach);
}

int run(const CommandLine& line, const Arguments& args) {
  const SceneDescription scene = loadScene(args.scene, args.packages);
  if (args.dry_run) return dryRun(line, scene);
  if (args.min_distance.empty()) throw UsageError("--min-distance is required (or --dry-run)");
  const double limit = number(args.min_distance, "--min-distance");

  CheckResult all;
  auto reactions = nlohmann::ordered_json::array();
  std::string robots_text;
  std::vector<std::string> recordings = args.recordings;
  if (recordings.empty()) recordings.emplace_back();
  for (const auto& recording : recordings) {
    SessionOptions options;
    options.recording = recording;
    options.cut_things = args.cut_things;
    options.poses = args.poses;
    options.cache = line.cache;
    options.monitor = buildMonitor(line);
    // The gate leaves nothing out, whatever the scene allows.
    options.rest = 0.0;
    options.remember = false;
    options.horizon = options.budget = kInfinity;
    Session session(scene, options);
    if (!args.margins.empty()) applyMargins(session.scene(), args.margins);
    DistanceCheck check(session.scene(), limit, !args.margins.empty(), args.swept, recording);
    RunOptions run;
    run.progress = progressBar(line, recording.empty() ? "check" : recording);
    run.interrupted = interrupted;
    run.react = args.react == "on";
    run.on_cycle = [&](double t, const std::vector<PairResult>& results) { check.frame(t, results); };
    const RunSummary summary = runScene(session, run);
    check.finish(summary, all);
    if (summary.cycles > 0) {
      reactions.push_back({{"recording", recording}, {"robots", robotsJson(summary.robots)}});
      robots_text += (recordings.size() > 1 ? recording + ":\n" : "") + robotsText(summary.robots);
    }
    if (summary.interrupted) return kInterrupted;
  }
  const bool passed = all.violations.empty() && (!args.strict || all.unproven.empty());
  nlohmann::ordered_json document{{"passed", passed}, {"min_distance_limit", limit}, {"frames", all.frames}};
  std::string text;
  for (const auto* list : {&all.violations, &all.unproven}) {
    auto rows = nlohmann::ordered_json::array();
    for (const Violation& v : *list) {
      rows.push_back(violationJson(v));
      text += format("%s: %s to %s, %.3f s to %.3f s, %.1f mm (limit %.1f mm%s)\n",
                     list == &all.violations ? "broken" : "not proven", v.a.c_str(), v.b.c_str(), v.start,
                     v.end, 1e3 * v.min_distance, 1e3 * v.limit, widened(v.reach).c_str());
    }
    document[list == &all.violations ? "violations" : "unproven"] = rows;
  }
  document["stale"] = all.stale;
  if (args.swept) document["swept"] = {{"queries", all.swept_queries}};
  if (!reactions.empty()) document["reactions"] = reactions;
  text += robots_text;
  for (const auto& name : all.stale)
    line.warn(name + " was stale or refused at some time: its distances are not proven");
  text += passed ? "passed\n" : "not passed\n";
  if (!args.junit.empty()) writeJunit(all, args.scene, args.junit);
  if (!args.report.empty()) writeHtmlReport(all, args.scene, limit, args.report);
  line.print(document, text);
  return passed ? kDone : kLimitBroken;
}

}  // namespace

void addCheck(CLI::App& root, CommandLine& line) {
  auto* command =
      addCommand(root, line, "check", "the gate for scripts: exit 1 when a limit is broken",
                 "abstand check cell.yaml --recording reach.bvh --min-distance 0.1 --junit result.xml");
  auto args = std::make_shared<Arguments>();
  command->add_option("SCENE", args->scene, "scene file")->required();
  command->add_option("--recording", args->recordings, "recordings, each checked in turn");
  command->add_flag(
      "--cut-things", args->cut_things,
      "the depth images show the scene's robots and objects where the scene has them: they are cut out");
  command->add_option("--poses", args->poses, "CSV of poses that named objects follow");
  command->add_option("--min-distance", args->min_distance, "smallest distance allowed, m");
  command->add_option("--margins", args->margins,
                      "YAML, NAME: metres; a pair then needs the sum of its margins too");
  command->add_option("--junit", args->junit, "JUnit XML");
  command->add_option("--report", args->report, "HTML page");
  command
      ->add_option("--react", args->react,
                   "on: mechanisms with a reaction move away, and every millisecond is checked; off: they "
                   "follow their motion")
      ->check(CLI::IsMember({"on", "off"}));
  command->add_flag("--dry-run", args->dry_run, "print the scene as it was understood");
  command->add_flag("--strict", args->strict,
                    "fail also where distance minus its error bound is below the limit");
  command->add_flag("--swept", args->swept,
                    "between frames too: certified for bodies that go straight from pose to pose");
  addPackagePath(command, args->packages);
  addCacheFlag(command, line);
  command->callback([&line, args] { line.run = [&line, args] { return run(line, *args); }; });
}

}  // namespace abstand::cli
