// Runs another program without a shell.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace abstand::report {

/// Path of the program in PATH; nullopt if there is none.
std::optional<std::filesystem::path> findProgram(const std::string& name);

struct ProgramEnd {
  int code{-1};            ///< exit code; -1: ended by a signal, or not started
  bool timed_out{false};   ///< killed after `max_seconds`
  std::string last_words;  ///< last line of its output, truncated to some hundred bytes
};

/// Runs a program with these arguments until it ends, without input; it and its descendants are killed after
/// `max_seconds`. Throws UsageError if no process can be created, and Interrupted.
ProgramEnd runProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                      double max_seconds);

}  // namespace abstand::report
