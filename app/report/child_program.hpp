// Another program, run without a shell.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace abstand::report {

/// The program that a name stands for in PATH; nothing where there is none.
std::optional<std::filesystem::path> findProgram(const std::string& name);

struct ProgramEnd {
  int code{-1};            ///< exit code; -1: ended by a signal, or not started
  bool timed_out{false};   ///< killed after `max_seconds`
  std::string last_words;  ///< the last line that it printed, at most some hundred bytes
};

/// Runs a program with these arguments until its end, without input; it and what it started are killed after
/// `max_seconds`. Throws UsageError where no process can be made, and Interrupted.
ProgramEnd runProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                      double max_seconds);

}  // namespace abstand::report
