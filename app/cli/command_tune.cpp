// abstand tune: what safety margins would have done over recordings, and which are proposed.
#include <cmath>

#include "app/cli/command_line.hpp"
#include "app/cli/reservation_texts.hpp"
#include "app/cli/tune_texts.hpp"
#include "app/cli/warm_start.hpp"
#include "app/depth/open_session.hpp"
#include "core/base/error.hpp"
#include "core/base/interrupt.hpp"

namespace abstand::cli {
namespace {

constexpr std::size_t kMaxMargins = 100000;

struct TuneArguments {
  std::string scene, margins{"0:0.5:0.05"}, limit, reaction_time, deceleration, restart_time;
  std::vector<std::string> recordings;
  bool cut_things{false};
  WarmStartArguments warm_start;
  robot_file::PackagePaths packages;
};

/// "from:to:step" or one number; m, rising.
std::vector<double> marginList(const std::string& text) {
  std::vector<double> numbers;
  std::string rest = text;
  for (auto colon = rest.find(':'); colon != std::string::npos; colon = rest.find(':')) {
    numbers.push_back(numberWithin(rest.substr(0, colon), "--margins", 0.0, 10.0, "m"));
    rest = rest.substr(colon + 1);
  }
  numbers.push_back(numberWithin(rest, "--margins", 0.0, 10.0, "m"));
  if (numbers.size() == 1) return numbers;
  if (numbers.size() != 3 || !(numbers[2] > 0.0) || numbers[1] < numbers[0])
    throw UsageError("--margins: found '" + text + "', expected FROM:TO:STEP in metres, or one margin");
  const double steps = std::floor((numbers[1] - numbers[0]) / numbers[2] + 1e-9);
  if (steps >= static_cast<double>(kMaxMargins))
    throw UsageError("--margins: found more than " + std::to_string(kMaxMargins) +
                     " margins, expected fewer");
  std::vector<double> list;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(steps); ++i)
    list.push_back(numbers[0] + static_cast<double>(i) * numbers[2]);
  return list;
}

tune::TuneOptions optionsOf(const TuneArguments& args) {
  tune::TuneOptions o;
  if (!args.limit.empty()) o.pass.limit = numberWithin(args.limit, "--limit", 0.0, 10.0, "m");
  if (!args.reaction_time.empty())
    o.pass.braking.reaction_time = numberWithin(args.reaction_time, "--reaction-time", 0.0, 10.0, "s");
  if (!args.deceleration.empty())
    o.pass.braking.deceleration =
        numberWithin(args.deceleration, "--deceleration", 1e-3, 1e6, "rad/s^2 or m/s^2");
  if (!args.restart_time.empty())
    o.restart_time = numberWithin(args.restart_time, "--restart-time", 0.0, 1e4, "s");
  return o;
}

tune::TunedRecording tuneOne(const CommandLine& line, const TuneArguments& args,
                             const scene_file::SceneDescription& scene, const std::string& recording,
                             const tune::TuneOptions& options) {
  session::SessionOptions session_options;
  session_options.recording = recording;
  session_options.cut_things = args.cut_things;
  session_options.cache = line.cache;
  session_options.monitor = buildMonitor(line);
  args.warm_start.apply(session_options);
  // Nothing is left out, whatever the scene allows.
  session_options.rest = 0.0;
  session_options.horizon = session_options.budget = kInfinity;
  const auto session = depth::openSession(scene, session_options);
  const std::string name = recording.empty() ? args.scene : recording;
  run::RunOptions run;
  run.progress = progressBar(line, name);
  run.interrupted = interrupted;
  return tune::tuneRecording(*session, options, run, name);
}

/// A recording that cannot be read does not stop the others.
TuneAnswer tuneAll(const CommandLine& line, const TuneArguments& args,
                   const scene_file::SceneDescription& scene, const tune::TuneOptions& options) {
  TuneAnswer answer;
  std::vector<std::string> recordings = args.recordings;
  if (recordings.empty()) recordings.emplace_back();
  for (const std::string& recording : recordings) {
    try {
      answer.recordings.push_back(tuneOne(line, args, scene, recording, options));
      answer.interrupted = answer.recordings.back().interrupted;
    } catch (const ParseError& e) {
      if (recordings.size() == 1) throw;
      answer.failed.push_back({recording, e.what()});
    } catch (const structure::BuildCancelled&) {
      answer.interrupted = true;
    } catch (const Interrupted&) {
      answer.interrupted = true;
    }
    if (answer.interrupted) break;
  }
  return answer;
}

int runTune(const CommandLine& line, const TuneArguments& args) {
  const tune::TuneOptions options = optionsOf(args);
  const std::vector<double> margins = marginList(args.margins);
  const scene_file::SceneDescription scene = scene_file::loadScene(args.scene, args.packages);
  TuneAnswer answer = tuneAll(line, args, scene, options);
  for (const auto& [recording, error] : answer.failed) line.warn(error);
  if (answer.recordings.empty()) {
    if (answer.interrupted) return kInterrupted;
    throw UsageError("found no recording that could be read, expected one");
  }
  answer.options = options;
  answer.table = tune::marginTable(answer.recordings, margins, options);
  line.print(tuneJson(answer), tuneText(answer));
  if (answer.interrupted) return kInterrupted;
  return answer.failed.empty() ? kDone : kPartly;
}

}  // namespace

void addTune(CLI::App& root, CommandLine& line) {
  auto* command = addCommand(root, line, "tune",
                             "what safety margins would have done over recordings; which are proposed",
                             "abstand tune cell.yaml --recordings reach.bvh walk.bvh --margins 0:0.4:0.02");
  auto args = std::make_shared<TuneArguments>();
  command->add_option("SCENE", args->scene, "scene file")->required();
  command->add_option("--recordings", args->recordings,
                      "recordings of people, each beside the scene's robots");
  command->add_option("--margins", args->margins, "FROM:TO:STEP in metres (default: 0:0.5:0.05)");
  command->add_option("--limit", args->limit,
                      "m: clearance that a moving robot must keep (default: 0, no touch)");
  command->add_option("--reaction-time", args->reaction_time,
                      "s, from the frame that breaks a margin until the robot slows down (default: 0.1)");
  command->add_option("--deceleration", args->deceleration,
                      "rad/s^2 or m/s^2, of every joint on its path (default: 5)");
  command->add_option("--restart-time", args->restart_time,
                      "s, from the end of an intrusion until the robot goes on (default: 0)");
  command->add_flag(
      "--cut-things", args->cut_things,
      "the depth images show the scene's robots and objects where the scene has them: they are cut out");
  addWarmStart(*command, args->warm_start);
  addPackagePath(command, args->packages);
  addCacheFlag(command, line);
  command->callback([&line, args] { line.run = [&line, args] { return runTune(line, *args); }; });
}

}  // namespace abstand::cli
