// abstand tune: outcomes of safety margins over recordings, and proposed margins.
#include <cstdlib>

#include "app/cli/command_line.hpp"
#include "app/cli/cut_things.hpp"
#include "app/cli/pass_arguments.hpp"
#include "app/cli/question_arguments.hpp"
#include "app/cli/speed_texts.hpp"
#include "app/cli/tune_arguments.hpp"
#include "app/cli/tune_speeds.hpp"
#include "app/cli/tune_texts.hpp"
#include "app/cli/version.hpp"
#include "app/cli/warm_start.hpp"
#include "app/cli/worn_arguments.hpp"
#include "app/depth/open_session.hpp"
#include "app/report/moment_picture.hpp"
#include "app/report/report_file.hpp"
#include "app/results/result_index.hpp"
#include "app/tune/result_file.hpp"
#include "core/base/error.hpp"
#include "core/base/interrupt.hpp"
#include "core/base/temporary_folder.hpp"
#include "core/base/write_error.hpp"

namespace abstand::cli {
namespace {

struct TuneArguments {
  std::string scene, out, shard;
  std::vector<std::string> recordings;
  QuestionArguments questions;
  PassArguments pass;
  int jobs{1};
  std::optional<bool> cut_things;
  bool worst_phase{false};
  SpeedArguments speeds;
  WornArguments worn;
  WarmStartArguments warm_start;
  robot_file::PackagePaths packages;
};

session::SessionOptions sessionOptions(const CommandLine& line, const TuneArguments& args,
                                       const std::string& recording) {
  session::SessionOptions options;
  options.recording = recording;
  options.cut_things = args.cut_things;
  options.cache = line.cache;
  args.warm_start.apply(options);
  // Disables culling, whatever the scene allows.
  options.rest = 0.0;
  options.horizon = options.budget = kInfinity;
  return options;
}

/// The runs named by the arguments.
std::vector<tune::PlanItem> itemsOf(const TuneArguments& args) {
  std::vector<tune::PlanItem> items;
  if (tune::isPlan(args.scene)) {
    if (!args.recordings.empty())
      throw UsageError(
          "--recordings: found together with a plan, expected one of them: a plan names its recordings");
    items = tune::loadPlan(args.scene);
  } else {
    for (const std::string& recording : args.recordings)
      items.push_back({args.scene, recording, {}, {}, 1.0, {}, recording});
    if (items.empty()) items.push_back({args.scene, {}, {}, {}, 1.0, {}, args.scene});
  }
  const tune::WornVariant worn = args.worn.worn();
  for (tune::PlanItem& item : items) item.worn_always = worn;
  return items;
}

/// Runs sequentially in this process, with results in `folder`, which the caller removes. An unreadable
/// recording does not stop the others.
tune::TuneAnswer tuneHere(const std::filesystem::path& folder, const CommandLine& line,
                          const TuneArguments& args, const std::vector<tune::PlanItem>& items,
                          const tune::TuneOptions& options) {
  tune::TuneAnswer answer;
  answer.options = options;
  tune::HeldFrames held;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const tune::PlanItem& item = items[i];
    try {
      scene_file::SceneDescription scene = scene_file::loadScene(item.scene, args.packages);
      item.apply(scene);
      session::SessionOptions session_options = sessionOptions(line, args, item.recording.string());
      session_options.monitor = buildMonitor(line);
      const auto session = depth::openSession(std::move(scene), session_options);
      run::RunOptions run;
      run.progress = progressBar(line, item.name);
      run.interrupted = interrupted;
      const std::filesystem::path file = folder / (std::to_string(i) + ".h5");
      tune::ResultWriter writer(file, {}, hdf5::Compression::kNone);
      tune::TuneOptions tune = options;
      tune.pass.keep_frames = session->frameTimes().size() <= held.left() / humanmodel::kBodyPartCount;
      tune.pass.on_frame = [&](const tune::SettledFrame& frame, const tune::PassResult& names) {
        writer.frame(frame, names);
      };
      answer.recordings.push_back(tune::tuneRecording(*session, tune, run, item.name));
      writer.commit(answer.recordings.back(), tune);
      answer.recordings.back().file = file;
      held.take(answer.recordings.back());
      answer.interrupted = answer.recordings.back().interrupted;
      if (args.worst_phase && !answer.interrupted) {
        tune::WorstPhaseOptions phases;
        phases.enough = options.pass.limit;
        phases.calibration_error = options.pass.calibration_error;
        phases.interrupted = interrupted;
        phases.progress = progressBar(line, "worst phase");
        answer.worst_phases.push_back({item.name, tune::worstPhases(*session, phases)});
        answer.interrupted = interrupted();
      }
    } catch (const ParseError& e) {
      if (items.size() == 1) throw;
      answer.failed.push_back({item.name, e.what()});
    } catch (const structure::BuildCancelled&) {
      answer.interrupted = true;
    } catch (const Interrupted&) {
      answer.interrupted = true;
    }
    if (answer.interrupted) break;
  }
  std::stable_sort(answer.recordings.begin(), answer.recordings.end(),
                   [](const auto& a, const auto& b) { return a.recording < b.recording; });
  return answer;
}

/// Updates the folder's index (app/results/result_index.hpp); a failure is only a warning.
void refreshIndex(const CommandLine& line, const std::filesystem::path& folder) {
  try {
    const results::ResultIndex index = results::resultIndex(folder);
    if (!index.not_written.empty()) line.warn("the index could not be written: " + index.not_written);
  } catch (const UsageError&) {
    // One of several folders may be empty.
  }
}

/// Runs in child processes, with a result file each.
tune::TuneAnswer tuneInto(const std::filesystem::path& folder, const CommandLine& line,
                          const TuneArguments& args, const std::vector<tune::PlanItem>& items,
                          const tune::TuneOptions& options, const tune::Shard& shard) {
  tune::StudyOptions study;
  study.tune = options;
  study.folder = folder;
  study.jobs = args.jobs;
  const std::string cut_things = args.cut_things ? (*args.cut_things ? "cut_things " : "no_cut_things ") : "";
  study.settings = cut_things + (args.warm_start.cold ? "cold " : "") + args.warm_start.tolerance;
  study.shard = shard;
  study.interrupted = interrupted;
  study.progress = progressBar(line, "tune");
  study.load = [&](const std::filesystem::path& scene) {
    return scene_file::loadScene(scene, args.packages);
  };
  study.open = [&](scene_file::SceneDescription scene, const std::filesystem::path& recording) {
    session::SessionOptions session_options = sessionOptions(line, args, recording.string());
    session_options.threads = 1;
    session_options.monitor.cancelled = interrupted;
    return depth::openSession(std::move(scene), session_options);
  };
  const tune::StudyReport report = tune::runStudy(items, study);
  tune::TuneAnswer answer;
  answer.failed = report.failed;
  answer.interrupted = report.interrupted;
  answer.made = report.made;
  answer.kept = report.kept;
  answer.options = options;
  if (folder == args.out && report.made + report.kept > 0 && !report.interrupted) refreshIndex(line, folder);
  if (report.made + report.kept > 0) answer.recordings = tune::mergeResults({folder}).recordings;
  return answer;
}

/// Draws moments of a study's runs.
class MomentPainter {
 public:
  MomentPainter(const CommandLine& line, const TuneArguments& args, std::vector<tune::PlanItem> items)
      : line_(line), args_(args), items_(std::move(items)) {}

  /// Empty if the run is not part of the study.
  std::string picture(const tune::TunedRecording& recording, const tune::Approach& approach) {
    if (!open(recording.recording)) return {};
    session_->step(approach.t);
    const std::string& link = recording.pass.links[approach.link];
    const std::string part = nearestPart(link, recording.pass.parts[approach.part].part);
    return report::momentPicture(*session_, {part, link});
  }

 private:
  bool open(const std::string& run) {
    if (session_ && run == opened_) return true;
    const auto item =
        std::find_if(items_.begin(), items_.end(), [&](const auto& i) { return i.name == run; });
    if (item == items_.end()) return false;
    scene_file::SceneDescription scene = scene_file::loadScene(item->scene, args_.packages);
    item->apply(scene);
    session_ = depth::openSession(std::move(scene), sessionOptions(line_, args_, item->recording.string()));
    opened_ = run;
    return true;
  }
  /// Of several people the one whose part is nearest to the link.
  std::string nearestPart(const std::string& link_name, const std::string& wanted) const {
    const scene::Scene& scene = session_->scene();
    std::string part;
    double least = kInfinity;
    ObjectId link{0};
    if (!scene.find(link_name, &link)) return part;
    for (const PairId id : scene.pairsOf(link)) {
      const scene::Pair& pair = scene.pairs()[id.index()];
      const std::string& name = scene.object(pair.a == link ? pair.b : pair.a).spec.name;
      // PERSON/PART, or PERSON/PART/TOOL.
      const bool is_part = name.ends_with("/" + wanted) || name.find("/" + wanted + "/") != std::string::npos;
      if (is_part && pair.result.distance < least) part = name, least = pair.result.distance;
    }
    return part;
  }

  const CommandLine& line_;
  const TuneArguments& args_;
  std::vector<tune::PlanItem> items_;
  std::unique_ptr<session::Session> session_;
  std::string opened_;
};

struct Asked {
  const QuestionArguments& arguments;
  tune::TuneQuestions questions;
  std::string command;
  std::function<std::string(const tune::TunedRecording&, const tune::Approach&)> picture{};
  /// Completes the answer once its tables are set; false: a speed profile is not proven.
  std::function<bool(tune::TuneAnswer&)> study_speeds{};
};

int finish(const CommandLine& line, tune::TuneAnswer& answer, const Asked& asked) {
  for (const auto& failed : answer.failed) line.warn(failed.recording + ": " + failed.error);
  if (answer.recordings.empty()) {
    if (answer.interrupted) return kInterrupted;
    if (answer.failed.empty()) {
      line.print({{"recordings", 0}}, "no runs in this shard\n");
      return kDone;
    }
    throw ParseError({asked.command}, "found no usable recording, expected at least one");
  }
  tune::answerQuestions(asked.questions, answer);
  bool proven = true;
  if (asked.study_speeds && !answer.interrupted) proven = asked.study_speeds(answer);
  const std::string& report = asked.arguments.report;
  if (!report.empty()) report::writeReportFile(answer, {kVersion, asked.command, asked.picture}, report);
  asked.arguments.writeMargins(answer);
  line.print(tuneJson(answer), tuneText(answer));
  if (answer.interrupted) return kInterrupted;
  if (!proven) {
    line.warn(proofLine(answer));
    return kLimitBroken;
  }
  return answer.failed.empty() ? kDone : kPartly;
}

/// Runs of replays, with the same options as the command's; results are not kept.
tune::ReplayRuns replayItems(const CommandLine& line, const TuneArguments& args,
                             const std::vector<tune::PlanItem>& items, const tune::TuneOptions& options) {
  TuneArguments plain = args;
  plain.worst_phase = false;
  tune::TuneAnswer answer;
  const auto results = std::make_shared<const TemporaryFolder>();
  try {
    answer = args.jobs > 1 ? tuneInto(results->path(), line, plain, items, options, {})
                           : tuneHere(results->path(), line, plain, items, options);
  } catch (const ParseError& e) {
    answer.failed.push_back({items.front().name, e.what()});
  }
  for (tune::TunedRecording& r : answer.recordings) r.file_owner = results;
  return {std::move(answer.recordings), std::move(answer.failed), answer.interrupted};
}

int runTune(const CommandLine& line, const TuneArguments& args) {
  const tune::TuneOptions options = args.pass.options();
  Asked asked{args.questions, args.questions.questions(), args.scene};
  const std::vector<tune::PlanItem> items = itemsOf(args);
  MomentPainter painter(line, args, items);
  asked.picture = [&](const tune::TunedRecording& r, const tune::Approach& a) {
    return painter.picture(r, a);
  };
  const TemporaryFolder folder;
  const tune::Shard shard = shardOf(args.shard);
  std::optional<SpeedStudy> speeds;
  if (args.speeds.any()) {
    if (shard.count > 1)
      throw UsageError(
          "--speed-profile, --speed-scales: found together with a shard of several, expected all runs in "
          "one");
    speeds.emplace(args.speeds, items, [&](const tune::PlanItem& item) {
      scene_file::SceneDescription scene = scene_file::loadScene(item.scene, args.packages);
      item.apply(scene);
      return scene;
    });
    asked.study_speeds = [&](tune::TuneAnswer& answer) {
      const TemporaryFolder motions;
      return speeds->run(answer, motions.path(), [&](const std::vector<tune::PlanItem>& more) {
        return replayItems(line, args, more, options);
      });
    };
  }
  tune::TuneAnswer answer;
  if (args.worst_phase && (!args.out.empty() || args.jobs > 1))
    throw UsageError("--worst-phase: found together with --out or --jobs, expected one of them");
  if (!args.out.empty()) {
    answer = tuneInto(args.out, line, args, items, options, shard);
  } else if (args.jobs > 1) {
    answer = tuneInto(folder.path(), line, args, items, options, shard);
  } else {
    answer = tuneHere(folder.path(), line, args, tune::partOf(items, shard), options);
  }
  return finish(line, answer, asked);
}

struct MergeArguments {
  std::vector<std::string> folders;
  std::string restart_time;
  QuestionArguments questions;
};

int runMerge(const CommandLine& line, const MergeArguments& args) {
  const Asked asked{args.questions, args.questions.questions(), "merged results"};
  tune::TuneAnswer answer = tune::mergedAnswer({args.folders.begin(), args.folders.end()});
  takeRestartTime(args.restart_time, answer.options);
  for (const std::string& folder : args.folders)
    if (std::error_code ec; std::filesystem::is_directory(std::filesystem::path(folder) / "results", ec))
      refreshIndex(line, folder);
  return finish(line, answer, asked);
}

}  // namespace

void addTune(CLI::App& root, CommandLine& line) {
  auto* command =
      addCommand(root, line, "tune", "evaluates safety margins over recordings and proposes margins",
                 "abstand tune cell.yaml --recordings reach.bvh walk.bvh --margins 0:0.4:0.02");
  auto args = std::make_shared<TuneArguments>();
  command->add_option("SCENE", args->scene, "scene file, or a plan of many runs (docs/margins.md)")
      ->required();
  command->add_option("--recordings", args->recordings,
                      "recordings of people, each run with the scene's robots");
  args->questions.add(*command, line);
  args->pass.add(*command);
  command->add_flag("--worst-phase", args->worst_phase,
                    "smallest certified clearance over all phases of the robots' programs");
  addSpeedStudy(*command, line, args->speeds);
  args->worn.add(*command);
  addCutThings(*command, args->cut_things);
  command->add_option("--out", args->out,
                      "folder for one result file per run; existing results are not run again");
  command->add_option("--jobs", args->jobs, "number of parallel runs, one process each (default: 1)")
      ->check(CLI::Range(1, 256));
  command->add_option("--shard", args->shard,
                      "I/N: shard I of N of the runs; /N: I from an array job of Slurm, Grid Engine, PBS or "
                      "LSF, or from GNU parallel (docs/margins.md)");
  addWarmStart(*command, args->warm_start);
  addPackagePath(command, args->packages);
  addCacheFlag(command, line);
  command->callback([&line, args] { line.run = [&line, args] { return runTune(line, *args); }; });
}

void addMerge(CLI::App& root, CommandLine& line) {
  auto* command =
      addCommand(root, line, "merge", "evaluates stored results like tune, from any number of shards",
                 "abstand merge results --margins 0:0.4:0.02");
  auto args = std::make_shared<MergeArguments>();
  command->add_option("FOLDER", args->folders, "folders of `tune --out`")->required();
  args->questions.add(*command, line);
  command->add_option("--restart-time", args->restart_time,
                      "restart time in s: from the end of an intrusion until the robot resumes (default: 0)");
  command->callback([&line, args] { line.run = [&line, args] { return runMerge(line, *args); }; });
}

}  // namespace abstand::cli
