#include "app/cli/tune_arguments.hpp"

#include <cmath>

#include "app/cli/array_task.hpp"
#include "app/cli/command_line.hpp"
#include "core/base/error.hpp"

namespace abstand::cli {
namespace {

constexpr std::size_t kMaxMargins = 100000;

}  // namespace

std::vector<double> marginList(const std::string& text) {
  std::vector<double> numbers;
  std::string rest = text;
  for (auto colon = rest.find(':'); colon != std::string::npos; colon = rest.find(':')) {
    numbers.push_back(numberWithin(rest.substr(0, colon), "--margins", 0.0, 10.0, "m"));
    rest = rest.substr(colon + 1);
  }
  numbers.push_back(numberWithin(rest, "--margins", 0.0, 10.0, "m"));
  if (numbers.size() == 1) return numbers;
  if (numbers.size() != 3 || !(numbers[2] > 0.0) || numbers[1] < numbers[0])
    throw UsageError("--margins: found '" + text + "', expected FROM:TO:STEP in metres, or one margin");
  // Includes an end that is on a step up to rounding.
  const double steps = std::floor((numbers[1] - numbers[0]) / numbers[2] + 1e-9);
  if (steps >= static_cast<double>(kMaxMargins))
    throw UsageError("--margins: found more than " + std::to_string(kMaxMargins) +
                     " margins, expected fewer");
  std::vector<double> list;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(steps); ++i)
    list.push_back(numbers[0] + static_cast<double>(i) * numbers[2]);
  return list;
}

double restartTime(const std::string& text) {
  return text.empty() ? 0.0 : numberWithin(text, "--restart-time", 0.0, 1e4, "s");
}

void takeRestartTime(const std::string& text, tune::TuneOptions& options) {
  options.restart_time = restartTime(text);
  std::erase(options.stated, "restart_time");
  if (!text.empty()) options.stated.emplace_back("restart_time");
}

double segmentLength(const std::string& text) {
  return text.empty() ? 1.0 : numberWithin(text, "--segment", 0.01, 1e4, "s");
}

tune::Shard shardOf(const std::string& text) {
  if (text.empty()) {
    const auto task = arrayTask();
    if (task && task->count && *task->count > 1 && task->index < *task->count)
      return {task->index, *task->count};
    return {};
  }
  const auto slash = text.find('/');
  const auto count = slash == std::string::npos ? std::nullopt : wholeNumber(text.substr(slash + 1), 1.0);
  if (!count) throw UsageError("--shard: found '" + text + "', expected I/N with I from 1 to N, or /N");
  if (slash == 0) {
    const auto task = arrayTask();
    if (!task || task->index >= *count)
      throw UsageError("--shard: found '" + text + "' and no " + kArrayVariables +
                       " that fits, expected I/N");
    return {task->index, *count};
  }
  const auto number = wholeNumber(text.substr(0, slash), 1.0);
  if (!number || *number > *count)
    throw UsageError("--shard: found '" + text + "', expected I/N with I from 1 to N, or /N");
  return {*number - 1, *count};
}

}  // namespace abstand::cli
