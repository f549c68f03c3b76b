// abstand bench: benchmark of the included scenes.
#include <chrono>

#include "app/cli/bench_scenario.hpp"
#include "app/cli/command_line.hpp"
#include "app/depth/open_session.hpp"
#include "app/run/run_scene.hpp"
#include "core/base/data_folder.hpp"
#include "core/base/error.hpp"
#include "core/robot_file/mech_file.hpp"
#include "core/scene/cycle_statistics.hpp"

namespace abstand::cli {
namespace {

struct Benchmark {
  const char* name;
  const char* scene;  ///< below data/scenes
  const char* what;
};
constexpr Benchmark kScenes[] = {
    {"spheres", "spheres.yaml", "three spheres, 3 pairs"},
    {"rods", "rods.yaml", "two rods, 1 pair"},
    {"hug", "hug_alone.yaml", "HUG alone, 79 pairs"},
    {"boxing", "hug_boxing.yaml", "HUG and a boxer"},
    {"reach", "hug_reach.yaml", "HUG and a reaching person"},
};
constexpr int kFkBatch = 100;
constexpr int kFkSamples = 2000;

nlohmann::ordered_json benchFk() {
  using Steady = std::chrono::steady_clock;
  const mechanism::Mechanism chain = robot_file::loadMechanism(dataFolder() / "scenes" / "chain.mech");
  mechanism::MechanismState state;
  const std::vector<double> q(static_cast<std::size_t>(chain.dof), 0.3);
  mechanism::forward(chain, q, state);
  scene::CycleStatistics statistics(kInfinity);
  for (int i = 0; i < kFkSamples; ++i) {
    const auto begin = Steady::now();
    for (int k = 0; k < kFkBatch; ++k) mechanism::forward(chain, q, state);
    statistics.add(std::chrono::duration<double>(Steady::now() - begin).count() / kFkBatch);
  }
  return {{"name", "fk"},
          {"what", "forward kinematics of three links"},
          {"median_ns", 1e9 * statistics.median()},
          {"p99_ns", 1e9 * statistics.p99()}};
}

nlohmann::ordered_json benchScene(const CommandLine& line, const Benchmark& benchmark) {
  session::SessionOptions options;
  options.threads = 1;
  options.cache = false;
  options.monitor = buildMonitor(line);
  const auto opened =
      depth::openSession(scene_file::loadScene(dataFolder() / "scenes" / benchmark.scene), options);
  session::Session& session = *opened;
  run::RunOptions run;
  run.progress = progressBar(line, benchmark.name);
  run.interrupted = interrupted;
  const run::RunSummary s = run::runScene(session, run);
  return {{"name", benchmark.name},
          {"what", benchmark.what},
          {"pairs", s.pairs},
          {"frames", s.frames},
          {"median_ns", 1e3 * s.cycle_us.median},
          {"p99_ns", 1e3 * s.cycle_us.p99},
          {"p999_ns", 1e3 * s.cycle_us.p999},
          {"build_ms", s.build_ms},
          {"memory_bytes", s.memory_bytes}};
}

int runBench(const CommandLine& line, const std::string& name) {
  nlohmann::ordered_json document{{"benchmarks", nlohmann::ordered_json::array()}};
  std::string text;
  std::vector<std::string> known{"fk"};
  bool found = false;
  const auto add = [&](const nlohmann::ordered_json& row) {
    found = true;
    document["benchmarks"].push_back(row);
    text += format("%-8s %12.0f ns median %12.0f ns p99  %s", row["name"].get<std::string>().c_str(),
                   row["median_ns"].get<double>(), row["p99_ns"].get<double>(),
                   row["what"].get<std::string>().c_str());
    if (row.contains("build_ms"))
      text += format(", built in %.0f ms, %.1f MB", row["build_ms"].get<double>(),
                     row["memory_bytes"].get<double>() * 1e-6);
    text += "\n";
  };
  if (name.empty() || name == "fk") add(benchFk());
  for (const Benchmark& b : kScenes) {
    known.emplace_back(b.name);
    if (!name.empty() && name != b.name) continue;
    try {
      add(benchScene(line, b));
    } catch (const ParseError& e) {
      if (!name.empty()) throw;
      line.warn(std::string(b.name) + " skipped: " + e.what());
    }
    if (interrupted()) return kInterrupted;
  }
  if (!found) {
    std::string list;
    for (const auto& k : known) list += (list.empty() ? "" : ", ") + k;
    throw UsageError("found the unknown benchmark '" + name + "', expected one of " + list);
  }
  line.print(document, text);
  return kDone;
}

}  // namespace

void addBench(CLI::App& root, CommandLine& line) {
  auto* command = addCommand(
      root, line, "bench", "benchmarks of the project, one thread; or one row of a comparison benchmark",
      "abstand bench hug --json\n  abstand bench --scenario S3_hug_human --mode distance --variant h4");
  auto name = std::make_shared<std::string>();
  auto scenario = std::make_shared<BenchScenario>();
  command->add_option("NAME", *name, "fk, spheres, rods, hug, boxing or reach (default: all)");
  command->add_option("--scenario", scenario->scenario, "folder of a peer benchmark's scene");
  command->add_option("--mode", scenario->mode, "distance, collide, contact, both, dmin")
      ->check(CLI::IsMember({"distance", "collide", "contact", "both", "dmin"}));
  command->add_option(
      "--variant", scenario->variant,
      "h1, h2, h4: voxels of 1, 2, 4 mm; h1p1.5: points 1.5 mm apart; h4-rest0.05: with temporal culling");
  command->add_option("--block", scenario->block, "number of consecutive frames")
      ->check(CLI::Range(1, 1000000));
  command->add_option("--period", scenario->period, "of that many")->check(CLI::Range(1, 1000000));
  command->add_option("--start", scenario->start, "first frame")->check(CLI::Range(0, 100000000));
  command->add_option("--budget", scenario->budget, "seconds of measured work");
  line.output(command->add_option("--dump", scenario->dump, "binary file of the pairs' values"));
  line.output(command->add_option("--out", scenario->out, "file that the JSON line is appended to"));
  command->callback([&line, name, scenario] {
    line.run = [&line, name, scenario] {
      return scenario->scenario.empty() ? runBench(line, *name) : benchScenario(*scenario);
    };
  });
}

}  // namespace abstand::cli
