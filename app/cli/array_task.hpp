// Place of this process among the tasks of an array job.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace abstand::cli {

/// A number that a scheduler or GNU parallel has given to this process in an environment variable.
struct ArrayTask {
  std::string variable;              ///< the one that says it
  std::size_t index{0};              ///< from 0
  std::optional<std::size_t> count;  ///< of tasks, where the scheduler says it
};

/// Names of the variables, for messages and help.
inline constexpr const char* kArrayVariables =
    "SLURM_ARRAY_TASK_ID, SGE_TASK_ID, PBS_ARRAY_INDEX, PBS_ARRAYID, LSB_JOBINDEX or PARALLEL_SEQ";

/// Nullopt outside of array jobs. Slurm counts from SLURM_ARRAY_TASK_MIN in steps of SLURM_ARRAY_TASK_STEP,
/// Grid Engine from SGE_TASK_FIRST in steps of SGE_TASK_STEPSIZE; both say how many tasks there are. PBS,
/// Torque, LSF and GNU parallel say neither and count from 1. The number of a scheduler has priority over
/// that of GNU parallel, which may come from the shell that submitted the job. Throws UsageError if two
/// schedulers disagree, or for a PBS array that counts from 0.
std::optional<ArrayTask> arrayTask();

/// An integer from `least` to a million, or nullopt.
std::optional<std::size_t> wholeNumber(const std::string& text, double least);

}  // namespace abstand::cli
