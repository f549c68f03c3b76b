#include "app/tune/study.hpp"

#include <algorithm>

#include "app/tune/job_pool.hpp"
#include "app/tune/result_file.hpp"
#include "app/tune/result_key.hpp"
#include "core/base/error.hpp"
#include "core/base/input_log.hpp"
#include "core/base/interrupt.hpp"
#include "core/base/write_error.hpp"

namespace abstand::tune {
namespace {

namespace fs = std::filesystem;

fs::path resultFile(const fs::path& folder, const ContentKey& key) {
  return folder / "results" / (key.hex() + ".h5");
}

/// Outcome of a run.
enum RunEnd : int { kMade, kKept, kInterrupted };

/// Called in a child process.
RunEnd makeResult(const PlanItem& item, const StudyOptions& options) {
  try {
    scene_file::SceneDescription scene = options.load(item.scene);
    item.apply(scene);
    const ContentKey key = resultKey(scene, item.recording, options.tune, options.settings);
    const fs::path file = resultFile(options.folder, key);
    {
      // A damaged result is replaced, so it is not an input.
      const InputLogPause pause;
      if (isResult(file, key)) return kKept;
    }
    const auto session = options.open(std::move(scene), item.recording);
    ResultWriter writer(file, key);
    TuneOptions tune = options.tune;
    // The file has all frames, so that memory does not grow with them.
    tune.pass.keep_frames = false;
    tune.pass.on_frame = [&](const SettledFrame& frame, const PassResult& names) {
      writer.frame(frame, names);
    };
    run::RunOptions run;
    run.interrupted = options.interrupted;
    const TunedRecording tuned = tuneRecording(*session, tune, run, item.name);
    if (tuned.interrupted) return kInterrupted;
    writer.commit(tuned, tune);
    return kMade;
  } catch (const Interrupted&) {
  } catch (const structure::BuildCancelled&) {
  }
  return kInterrupted;
}

std::vector<double> numbersOf(const safety::SeparationOptions& options) {
  std::vector<double> numbers;
  safety::SeparationOptions::eachNumber(
      options, [&](const char*, const double& v, const config::NumberRule&) { numbers.push_back(v); });
  return numbers;
}

bool sameOptions(const StoredResult& x, const StoredResult& y) {
  const PassOptions &a = x.options.pass, &b = y.options.pass;
  if (numbersOf(a.separation) != numbersOf(b.separation)) return false;
  return a.limit == b.limit && a.near == b.near && a.calibration_error == b.calibration_error &&
         a.latency == b.latency && a.braking.reaction_time == b.braking.reaction_time &&
         a.braking.deceleration == b.braking.deceleration &&
         x.tuned.contact_limits == y.tuned.contact_limits &&
         x.tuned.separation_table == y.tuned.separation_table;
}

/// An option is stated where each of the results has it stated.
void keepStated(const std::vector<std::string>& names, std::vector<std::string>& stated) {
  std::erase_if(stated, [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) == names.end();
  });
}

}  // namespace

std::vector<PlanItem> partOf(const std::vector<PlanItem>& items, const Shard& shard) {
  std::vector<PlanItem> part;
  for (std::size_t i = shard.index; i < items.size(); i += shard.count) part.push_back(items[i]);
  return part;
}

StudyReport runStudy(const std::vector<PlanItem>& items, const StudyOptions& options) {
  const std::vector<PlanItem> mine = partOf(items, options.shard);
  std::error_code ec;
  fs::create_directories(options.folder / "results", ec);
  if (ec) throw WriteError((options.folder / "results").string(), ec.value());
  StudyReport report;
  std::vector<std::string> errors(mine.size());
  std::size_t done = 0;
  const bool all = runJobs(
      mine.size(), options.jobs, [&](std::size_t i) { return makeResult(mine[i], options); },
      [&](const JobEnd& end) {
        ++done;
        report.made += end.answer == kMade;
        report.kept += end.answer == kKept;
        report.interrupted = report.interrupted || end.answer == kInterrupted;
        if (!end.answer) errors[end.job] = end.message;
        if (options.progress) options.progress(done, mine.size());
      });
  report.interrupted = report.interrupted || !all;
  // In the order of the plan, independent of the order of completion.
  for (std::size_t i = 0; i < mine.size(); ++i)
    if (!errors[i].empty()) report.failed.push_back({mine[i].name, errors[i]});
  return report;
}

MergedResults mergeResults(const std::vector<fs::path>& folders, std::size_t held_frames) {
  std::vector<fs::path> files;
  for (const fs::path& folder : folders) {
    std::error_code ec;
    const fs::path results = fs::is_directory(folder / "results", ec) ? folder / "results" : folder;
    for (const auto& entry : fs::directory_iterator(results, ec))
      if (entry.path().extension() == ".h5") files.push_back(entry.path());
    if (ec) throw UsageError(folder.string() + ": " + ec.message() + ", expected a folder of results");
  }
  if (files.empty()) throw UsageError("found no results (*.h5), expected some in the folders");
  std::sort(files.begin(), files.end());
  struct Kept {
    StoredResult stored;
    fs::path file;
  };
  std::vector<Kept> kept;
  HeldFrames held(held_frames);
  for (const fs::path& file : files) {
    StoredResult stored = readResult(file, held.left());
    // The same result of two shards counts once.
    if (std::any_of(kept.begin(), kept.end(), [&](const Kept& k) { return k.stored.key == stored.key; }))
      continue;
    if (!kept.empty() && !sameOptions(kept.front().stored, stored))
      throw ParseError({file.string()}, "found a result with other options than in " +
                                            kept.front().file.string() +
                                            ", expected the same limit, reaction time, deceleration, "
                                            "calibration error, separation and table of contact limits");
    if (!kept.empty() && kept.front().stored.version != stored.version)
      throw ParseError({file.string()}, "found a result of another version than " +
                                            kept.front().file.string() + ", expected results of one version");
    held.take(stored.tuned);
    kept.push_back({std::move(stored), file});
  }
  std::sort(kept.begin(), kept.end(), [](const Kept& a, const Kept& b) {
    return std::tie(a.stored.tuned.recording, a.stored.key) <
           std::tie(b.stored.tuned.recording, b.stored.key);
  });
  MergedResults merged;
  merged.options = kept.front().stored.options;
  for (const Kept& k : kept) keepStated(k.stored.options.stated, merged.options.stated);
  for (Kept& k : kept) merged.recordings.push_back(std::move(k.stored.tuned));
  return merged;
}

}  // namespace abstand::tune
