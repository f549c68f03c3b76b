// Speed profiles and the trade of speed against margin, as `tune` is asked for them.
#pragma once

#include <memory>

#include "app/cli/command_line.hpp"
#include "app/tune/tune_answer.hpp"
#include "core/base/output_folder.hpp"

namespace abstand::cli {

struct SpeedArguments {
  std::string profile, scales;
  int max_iterations{10};
  bool any() const { return !profile.empty() || !scales.empty(); }
};

/// --speed-rule, of commands that print speeds.
void addSpeedRule(CLI::App& command, std::string& rule);
tune::SpeedRule speedRule(const std::string& name);
/// --speed-profile and what belongs to it.
void addSpeedStudy(CLI::App& command, CommandLine& line, SpeedArguments& args);

/// A study of speeds that was asked for. Made before anything costly: throws UsageError for arguments that
/// make no sense, runs with more than one program, and a profile that cannot be written; ParseError for a
/// motion that cannot be read.
class SpeedStudy {
 public:
  using Load = std::function<scene_file::SceneDescription(const tune::PlanItem&)>;
  SpeedStudy(const SpeedArguments& args, std::vector<tune::PlanItem> items, const Load& load);

  /// Adds proof, profile and trade to the answer, whose `speeds` are there. The profile is written where it
  /// is proven. False where it is not. `folder`: exists, for files of replays. Throws UsageError, WriteError.
  bool run(tune::TuneAnswer& answer, const std::filesystem::path& folder, const tune::RunItems& run_items);

 private:
  SpeedArguments args_;
  std::vector<tune::PlanItem> items_;
  std::vector<double> scales_;
  std::vector<tune::ProgramMotion> motions_;
  std::unique_ptr<OutputFolder> out_;
};

}  // namespace abstand::cli
