// Common options of `tune` and `merge`.
#pragma once

#include <string>
#include <vector>

#include "app/cli/command_line.hpp"
#include "app/tune/tune_answer.hpp"

namespace abstand::cli {

struct QuestionArguments {
  std::string margins{"0:0.5:0.05"}, segment, report, margins_out, by{"part"}, speed_rule;
  std::vector<std::string> margin_sets;

  void add(CLI::App& command, CommandLine& line);
  /// Reads the files of margin sets. Throws UsageError, also for a report as PDF without a converter, and
  /// ParseError.
  tune::TuneQuestions questions() const;
  /// Writes the proposed margins as a set, if requested. Throws UsageError if no margin suffices.
  void writeMargins(const tune::TuneAnswer& answer) const;
};

}  // namespace abstand::cli
