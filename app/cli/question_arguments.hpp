// What `tune` and `merge` ask of recordings.
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
  /// Reads the files of sets. Throws UsageError and ParseError.
  tune::TuneQuestions questions() const;
  /// The proposed margins as a set, where it was asked for. Throws UsageError where no margin would do.
  void writeMargins(const tune::TuneAnswer& answer) const;
};

}  // namespace abstand::cli
