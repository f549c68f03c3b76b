// Runs all items of a plan and stores result files.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "app/tune/margin_table.hpp"
#include "app/tune/part_frames.hpp"
#include "app/tune/plan.hpp"

namespace abstand::tune {

/// Part `index` (from 0) of `count`: every count-th run, starting there.
struct Shard {
  std::size_t index{0}, count{1};
};

std::vector<PlanItem> partOf(const std::vector<PlanItem>& items, const Shard& shard);

struct StudyOptions {
  TuneOptions tune;
  std::filesystem::path folder;  ///< of results: FOLDER/results/KEY.h5, each written once
  std::string settings;          ///< everything else that `open` depends on; part of the result key
  int jobs{1};
  Shard shard;
  /// Loads the scene of a file; opens a session of it with a recording.
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
  std::size_t made{0}, kept{0};  ///< results made now, and existing ones
  std::vector<FailedRun> failed;
  bool interrupted{false};
};

/// Runs the items that have no result yet. A failed or crashed run does not stop the others. Throws
/// UsageError and WriteError if the folder cannot be created.
StudyReport runStudy(const std::vector<PlanItem>& items, const StudyOptions& options);

/// All results of these folders sorted by name and key, regardless of which shard wrote them: the same
/// results give the same answer. Throws ParseError for a damaged one and for two of different versions or
/// options, and UsageError for a folder without results.
struct MergedResults {
  std::vector<TunedRecording> recordings;
  TuneOptions options;
};
/// `held_frames`: of HeldFrames.
MergedResults mergeResults(const std::vector<std::filesystem::path>& folders,
                           std::size_t held_frames = HeldFrames::kUsual);

}  // namespace abstand::tune
