// Speed profiles and the trade-off of speed against margin for `tune`.
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

/// Adds --speed-rule, for commands that print speeds.
void addSpeedRule(CLI::App& command, std::string& rule);
tune::SpeedRule speedRule(const std::string& name);
/// Adds --speed-profile and related options.
void addSpeedStudy(CLI::App& command, CommandLine& line, SpeedArguments& args);

/// A requested study of speeds. Constructed before expensive work: throws UsageError for inconsistent
/// arguments, runs with more than one program, and a profile that cannot be written; ParseError for an
/// unreadable motion.
class SpeedStudy {
 public:
  using Load = std::function<scene_file::SceneDescription(const tune::PlanItem&)>;
  SpeedStudy(const SpeedArguments& args, std::vector<tune::PlanItem> items, const Load& load);

  /// Adds proof, profile and trade-off to the answer, whose `speeds` are set. Writes the profile if it is
  /// proven; false if not. `folder`: exists, for files of replays. Throws UsageError, WriteError.
  bool run(tune::TuneAnswer& answer, const std::filesystem::path& folder, const tune::RunItems& run_items);

 private:
  SpeedArguments args_;
  std::vector<tune::PlanItem> items_;
  std::vector<double> scales_;
  std::vector<tune::ProgramMotion> motions_;
  std::unique_ptr<OutputFolder> out_;
};

}  // namespace abstand::cli
