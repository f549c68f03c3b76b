#include "app/cli/array_task.hpp"

#include <cmath>
#include <cstdlib>
#include <vector>

#include "core/base/error.hpp"
#include "core/base/number.hpp"

namespace abstand::cli {
namespace {

constexpr double kMaxTasks = 1e6;

std::optional<std::size_t> environment(const char* name) {
  const char* text = std::getenv(name);
  return text ? wholeNumber(text, 0.0) : std::nullopt;
}

/// Index of task `id` of an array that begins at `first`; nullopt if it is not on a step.
std::optional<std::size_t> indexOf(std::size_t id, std::size_t first, std::size_t step) {
  if (id < first || step == 0 || (id - first) % step != 0) return std::nullopt;
  return (id - first) / step;
}

std::optional<ArrayTask> slurmTask() {
  const auto id = environment("SLURM_ARRAY_TASK_ID");
  if (!id) return std::nullopt;
  const auto index = indexOf(*id, environment("SLURM_ARRAY_TASK_MIN").value_or(0),
                             environment("SLURM_ARRAY_TASK_STEP").value_or(1));
  if (!index) return std::nullopt;
  return ArrayTask{"SLURM_ARRAY_TASK_ID", *index, environment("SLURM_ARRAY_TASK_COUNT")};
}

/// SGE_TASK_ID is "undefined" outside of arrays.
std::optional<ArrayTask> gridEngineTask() {
  const auto id = environment("SGE_TASK_ID");
  if (!id) return std::nullopt;
  const std::size_t first = environment("SGE_TASK_FIRST").value_or(1),
                    step = environment("SGE_TASK_STEPSIZE").value_or(1);
  const auto index = indexOf(*id, first, step);
  if (!index) return std::nullopt;
  std::optional<std::size_t> count;
  if (const auto last = environment("SGE_TASK_LAST"); last && *last >= first)
    count = (*last - first) / step + 1;
  return ArrayTask{"SGE_TASK_ID", *index, count};
}

/// A number from 1, without a count.
std::optional<ArrayTask> countedFromOne(const char* variable) {
  const auto number = environment(variable);
  if (!number || *number == 0) return std::nullopt;
  return ArrayTask{variable, *number - 1, {}};
}

std::optional<ArrayTask> pbsTask(const char* variable) {
  if (environment(variable) == std::size_t{0})
    throw UsageError(std::string(variable) +
                     ": found 0, expected an array that counts from 1, or --shard I/N");
  return countedFromOne(variable);
}

}  // namespace

std::optional<std::size_t> wholeNumber(const std::string& text, double least) {
  const auto value = parseDouble(text);
  if (!value || *value != std::floor(*value) || *value < least || *value > kMaxTasks) return std::nullopt;
  return static_cast<std::size_t>(*value);
}

std::optional<ArrayTask> arrayTask() {
  std::optional<ArrayTask> task;
  // LSB_JOBINDEX is 0 outside of arrays.
  for (const auto& found : {slurmTask(), gridEngineTask(), pbsTask("PBS_ARRAY_INDEX"), pbsTask("PBS_ARRAYID"),
                            countedFromOne("LSB_JOBINDEX")}) {
    if (!found) continue;
    if (task && task->index != found->index)
      throw UsageError("found " + task->variable + " and " + found->variable +
                       ", which name different shards, expected one of them, or --shard I/N");
    if (!task) task = found;
  }
  return task ? task : countedFromOne("PARALLEL_SEQ");
}

}  // namespace abstand::cli
