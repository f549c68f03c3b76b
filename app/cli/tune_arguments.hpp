// What the commands about margins understand of their arguments.
#pragma once

#include <string>
#include <vector>

#include "app/tune/study.hpp"

namespace abstand::cli {

/// "FROM:TO:STEP" or one number; m, rising. Throws UsageError.
std::vector<double> marginList(const std::string& text);

/// `--restart-time`, s; without a text 0. Throws UsageError.
double restartTime(const std::string& text);
/// `--segment`, s; without a text 1. Throws UsageError.
double segmentLength(const std::string& text);

/// "I/N" with I from 1; "/N" takes I from SLURM_ARRAY_TASK_ID (counted from SLURM_ARRAY_TASK_MIN) or
/// PARALLEL_SEQ; without a text the whole, or in an array job of Slurm its part. Throws UsageError.
tune::Shard shardOf(const std::string& text);

}  // namespace abstand::cli
