// Options and texts about the warm start, of all commands that go through frames.
#pragma once

#include "app/cli/command_line.hpp"
#include "app/run/run_scene.hpp"

namespace abstand::cli {

/// What --cold, --remember and --tolerance say.
struct WarmStartArguments {
  bool cold{false}, warm{false};
  std::string tolerance;
  /// Throws UsageError.
  void apply(session::SessionOptions& session) const;
};

void addWarmStart(CLI::App& command, WarmStartArguments& args);

/// null: every frame started cold.
nlohmann::ordered_json warmStartJson(const run::RunSummary& summary);
/// A line, or nothing.
std::string warmStartText(const run::RunSummary& summary);

}  // namespace abstand::cli
