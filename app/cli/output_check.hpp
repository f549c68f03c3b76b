// Checks the outputs of a command line before expensive work starts.
#pragma once

#include "app/cli/command_line.hpp"

namespace abstand::cli {

/// Throws UsageError for an output of the selected subcommand that cannot be written, that is also an input
/// on the command line, that two options name, or that goes to standard output together with --json.
void checkOutputs(const CLI::App& root, const CommandLine& line);

}  // namespace abstand::cli
