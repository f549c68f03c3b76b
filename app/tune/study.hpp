// All runs of a plan, kept as result files.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "app/tune/margin_table.hpp"
#include "app/tune/plan.hpp"

namespace abstand::tune {

/// Part `index` (from 0) of `count`: every count-th run from there on.
struct Shard {
  std::size_t index{0}, count{1};
};

std::vector<PlanItem> partOf(const std::vector<PlanItem>& items, const Shard& shard);

struct StudyOptions {
  TuneOptions tune;
  std::filesystem::path folder;  ///< of results: FOLDER/results/KEY.h5, each written once
  std::string settings;          ///< whatever else `open` depends on: results with other settings are others
  int jobs{1};
  Shard shard;
  /// The scene of a file; and a session of it with this recording.
  std::function<scene_file::SceneDescription(const std::filesystem::path&)> load;
  std::function<std::unique_ptr<session::Session>(scene_file::SceneDescription, const std::filesystem::path&)>
      open;
  std::function<bool()> interrupted;
  std::function<void(std::size_t done, std::size_t all)> progress;
};

struct FailedRun {
  std::string recording, error;
};

struct StudyReport {
  std::size_t made{0}, kept{0};  ///< results that were made now, and that were there already
  std::vector<FailedRun> failed;
  bool interrupted{false};
};

/// Runs what has no result yet. A run that fails or crashes does not stop the others. Throws UsageError and
/// WriteError for a folder that cannot be made.
StudyReport runStudy(const std::vector<PlanItem>& items, const StudyOptions& options);

/// All results of these folders in the order of their names and keys, whatever wrote them: the same results
/// give the same answer. Throws ParseError for a damaged one, for two of different versions or options, and
/// UsageError for a folder without results.
struct MergedResults {
  std::vector<TunedRecording> recordings;
  TuneOptions options;
};
MergedResults mergeResults(const std::vector<std::filesystem::path>& folders);

}  // namespace abstand::tune
