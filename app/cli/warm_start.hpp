// Options and output about the warm start, for all commands that process frames.
#pragma once

#include "app/cli/command_line.hpp"
#include "app/run/run_scene.hpp"

namespace abstand::cli {

/// Values of --cold, --remember and --tolerance.
struct WarmStartArguments {
  bool cold{false}, warm{false};
  std::string tolerance;
  /// Throws UsageError.
  void apply(session::SessionOptions& session) const;
};

void addWarmStart(CLI::App& command, WarmStartArguments& args);

/// null: every frame started cold.
nlohmann::ordered_json warmStartJson(const std::optional<run::RunSummary::WarmStart>& warm_start);
/// One line, or empty.
std::string warmStartText(const std::optional<run::RunSummary::WarmStart>& warm_start);

}  // namespace abstand::cli
