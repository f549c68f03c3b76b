// Outputs of a command line, before anything costly begins.
#pragma once

#include "app/cli/command_line.hpp"

namespace abstand::cli {

/// Throws UsageError for an output of the chosen subcommand that cannot be written where it says, that is
/// also an input named on the command line, that another output has too, or that goes to standard output
/// beside --json.
void checkOutputs(const CLI::App& root, const CommandLine& line);

}  // namespace abstand::cli
