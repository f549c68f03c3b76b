// Options of a pass over recordings.
#pragma once

#include <string>
#include <vector>

#include "app/cli/command_line.hpp"
#include "app/tune/recording_tune.hpp"

namespace abstand::cli {

/// Assumptions about robots, sensors and contacts, as texts: numbers are parsed by options().
struct PassArguments {
  std::string limit, reaction_time, deceleration, restart_time, near, calibration_error, latency,
      contact_limits, separation_table;
  std::vector<std::string> separation, clamped;

  void add(CLI::App& command);
  /// Names of the options that were given (TuneOptions::stated).
  std::vector<std::string> stated() const;
  /// Reads the tables of contact limits and of the protective distance. Throws UsageError and ParseError.
  tune::TuneOptions options() const;
};

}  // namespace abstand::cli
