// Parses arguments of the commands about margins.
#pragma once

#include <string>
#include <vector>

#include "app/tune/study.hpp"

namespace abstand::cli {

/// "FROM:TO:STEP" or one number; m, increasing. Throws UsageError.
std::vector<double> marginList(const std::string& text);

/// `--restart-time`, s; 0 if empty. Throws UsageError.
double restartTime(const std::string& text);
/// The same for results that are read: replaces the restart time, and whether it was stated.
void takeRestartTime(const std::string& text, tune::TuneOptions& options);
/// `--segment`, s; 1 if empty. Throws UsageError.
double segmentLength(const std::string& text);

/// "I/N" with I from 1; "/N" takes I from the array job (arrayTask()); if empty the whole, or in an array job
/// that says how many tasks it has, its part. Throws UsageError.
tune::Shard shardOf(const std::string& text);

}  // namespace abstand::cli
