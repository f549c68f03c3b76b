// abstand pairs: finds pairs of bodies that can collide.
#include <chrono>
#include <map>
#include <optional>
#include <vector>

#include "app/cli/command_line.hpp"
#include "app/depth/open_session.hpp"
#include "app/run/collision_pairs.hpp"
#include "core/base/error.hpp"
#include "core/base/input_log.hpp"
#include "core/base/output_file.hpp"
#include "core/base/text_file.hpp"

namespace abstand::cli {
namespace {

struct PairsArguments {
  std::filesystem::path file, out, srdf;
  std::string voxel{"0.005"}, clearance;
  study::StudyOptions study;
  robot_file::PackagePaths packages;
};

/// A scene with only the robot, under the robot's name.
scene_file::SceneDescription sceneOf(const std::filesystem::path& robot_file, const std::string& voxel,
                                     const robot_file::PackagePaths& packages) {
  const std::string name = robot_file::loadRobot(robot_file).mechanism.name;
  const auto text = [](const std::string& s) { return nlohmann::json(s).dump(); };
  std::error_code ec;
  const auto file = std::filesystem::absolute(robot_file, ec);
  const std::string scene = "abstand: 1\ndefaults: {voxel: " + voxel + ", point: " + voxel +
                            "}\nmechanisms:\n  - {name: " + text(name) + ", file: " + text(file.string()) +
                            "}\n";
  return scene_file::parseScene(scene, file.parent_path() / "scene.yaml", packages);
}

scene_file::SceneDescription load(const PairsArguments& args) {
  const std::string extension = args.file.extension().string();
  if (extension == ".yaml" || extension == ".yml") return scene_file::loadScene(args.file, args.packages);
  return sceneOf(args.file, args.voxel, args.packages);
}

/// Keeps entries of the file from other sources.
std::string srdfFor(const std::filesystem::path& file, const robot_file::Srdf& srdf) {
  const InputLogPause pause;
  std::error_code ec;
  if (!std::filesystem::is_regular_file(file, ec) || std::filesystem::file_size(file, ec) == 0)
    return robot_file::srdfText(srdf);
  return robot_file::mergedSrdfText(readFile(file, robot_file::kMaxRobotBytes), file.string(), srdf);
}

using CollisionPairs = std::vector<run::CollisionPair>;

/// Writes the list and the SRDF, both or none.
void writePairs(const PairsArguments& args, const session::Session& session, const CollisionPairs& pairs) {
  std::optional<OutputFile> list, srdf;
  if (!args.out.empty()) list.emplace(args.out).stream() << run::pairsText(session, pairs, args.study);
  if (!args.srdf.empty()) srdf.emplace(args.srdf).stream() << srdfFor(args.srdf, run::srdfOf(session, pairs));
  for (auto* file : {&list, &srdf})
    if (*file) (*file)->finish();
  for (auto* file : {&list, &srdf})
    if (*file) (*file)->commit();
}

/// Report on the individual pairs.
struct PairsReport {
  std::map<std::string, int> counts{{"adjacent", 0}, {"never", 0},     {"always", 0},
                                    {"user", 0},     {"sometimes", 0}, {"undecided", 0}};
  int found_by_search{0};
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  std::string text;  ///< one line for each pair whose verdict depends on distances
};

void addToReport(const run::CollisionPair& p, const std::vector<scene::Object>& objects,
                 PairsReport& report) {
  const study::StudiedPair& s = p.study;
  const std::string verdict = study::verdictName(s.verdict);
  const std::string &a = objects[static_cast<std::size_t>(s.a)].spec.name,
                    &b = objects[static_cast<std::size_t>(s.b)].spec.name;
  ++report.counts[verdict];
  report.found_by_search += s.by_search ? 1 : 0;
  nlohmann::ordered_json row{{"verdict", verdict}, {"a", a}, {"b", b}};
  if (s.samples > 0) {
    row.update({{"distance", s.distance},
                {"bound", s.bound},
                {"samples", s.samples},
                {"hits", s.hits},
                {"by_search", s.by_search},
                {"posture", p.posture}});
    if (s.verdict != study::PairVerdict::kSometimes && s.verdict != study::PairVerdict::kUndecided)
      report.text += format("%s: %s, %s; minimum distance %.1f mm\n", verdict.c_str(), a.c_str(), b.c_str(),
                            1e3 * s.distance);
  }
  report.rows.push_back(std::move(row));
}

nlohmann::ordered_json pairsDocument(const PairsArguments& args, const session::Session& session,
                                     const PairsReport& report, double study_ms) {
  nlohmann::ordered_json document{{"bodies", session.scene().objects().size()},
                                  {"pairs", report.rows.size()}};
  for (const auto& [verdict, n] : report.counts) document[verdict] = n;
  document.update({{"found_by_search", report.found_by_search},
                   {"samples", args.study.samples},
                   {"seed", args.study.seed},
                   {"searches", args.study.searches},
                   {"clearance", args.study.clearance},
                   {"build_ms", session.buildMs()},
                   {"study_ms", study_ms},
                   {"list", report.rows},
                   {"remarks", session.remarks()},
                   {"interrupted", report.counts.at("undecided") > 0}});
  return document;
}

std::string pairsSummary(const PairsArguments& args, const PairsReport& report, std::size_t bodies,
                         double study_ms) {
  const auto count = [&](const char* verdict) { return report.counts.at(verdict); };
  std::string text = format(
      "%zu bodies, %zu pairs: %d adjacent, %d never, %d always, %d user, %d sometimes (%d of them found by "
      "search)\n"
      "%ld samples, seed %llu; %.1f s\n",
      bodies, report.rows.size(), count("adjacent"), count("never"), count("always"), count("user"),
      count("sometimes"), report.found_by_search, args.study.samples,
      static_cast<unsigned long long>(args.study.seed), 1e-3 * study_ms);
  if (const int open = count("undecided"); open > 0) {
    text += format("interrupted: %d %s undecided", open, open == 1 ? "pair is" : "pairs are");
    text += args.out.empty() && args.srdf.empty() ? "\n" : ", nothing was written\n";
  }
  return text;
}

int runPairs(const CommandLine& line, PairsArguments& args) {
  number(args.voxel, "--voxel");
  if (!args.clearance.empty()) args.study.clearance = number(args.clearance, "--clearance");
  args.study.validate();
  args.study.progress = progressBar(line, "pairs");
  args.study.interrupted = interrupted;
  session::SessionOptions options;
  options.cache = line.cache;
  options.monitor = buildMonitor(line);
  const auto opened = depth::openSession(load(args), options);
  session::Session& session = *opened;
  if (session.mechanisms().empty())
    throw UsageError("found a scene without a mechanism, expected at least one");

  const auto begin = std::chrono::steady_clock::now();
  const CollisionPairs pairs = run::collisionPairs(session, args.study);
  const double study_ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  PairsReport report;
  const auto& objects = session.scene().objects();
  for (const run::CollisionPair& p : pairs) addToReport(p, objects, report);
  // A list with undecided pairs cannot be used for checks.
  const bool incomplete = report.counts.at("undecided") > 0;
  if (!incomplete) writePairs(args, session, pairs);
  line.print(pairsDocument(args, session, report, study_ms),
             report.text + pairsSummary(args, report, objects.size(), study_ms));
  return incomplete ? kInterrupted : kDone;
}

}  // namespace

void addPairs(CLI::App& root, CommandLine& line) {
  auto* command = addCommand(root, line, "pairs",
                             "finds the pairs of bodies that can collide, by sampling the joint space",
                             "abstand pairs robot.urdf --out robot.pairs --srdf robot.srdf");
  auto args = std::make_shared<PairsArguments>();
  command->add_option("FILE", args->file, "scene (.yaml) or robot file (.mech or .urdf)")->required();
  command->add_option("--samples", args->study.samples, "random postures");
  command->add_option("--seed", args->study.seed, "random seed of the postures");
  command->add_option("--searches", args->study.searches,
                      "searches for a collision, per pair without a colliding posture");
  command->add_option("--clearance", args->clearance,
                      "clearance in m below which a pair counts as colliding (default: 0)");
  command->add_option("--voxel", args->voxel,
                      "voxel size in m of the structures, for a robot file (default: 0.005)");
  command
      ->add_option("--threads", args->study.threads,
                   "threads (0: all cores); the result does not depend on it")
      ->check(CLI::Range(0, 256));
  line.output(command->add_option("--out", args->out,
                                  "pairs file, for reading and for `pairs: {file: ...}` of a scene"));
  line.output(command->add_option("--srdf", args->srdf,
                                  "SRDF file with the link pairs that need no check; other content of an "
                                  "existing file is kept"));
  addPackagePath(command, args->packages);
  addCacheFlag(command, line);
  command->callback([&line, args] { line.run = [&line, args] { return runPairs(line, *args); }; });
}

}  // namespace abstand::cli
