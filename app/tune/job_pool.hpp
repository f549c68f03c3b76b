// Runs jobs in child processes, so that a crash affects only one job.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace abstand::tune {

/// Result of a job.
struct JobEnd {
  std::size_t job{0};
  std::optional<int> answer;  ///< return value of work(); empty if it threw or its process died
  std::string message;        ///< reason: text of the exception, or the signal that ended the process
};

/// Calls work(0) ... work(count - 1), each once, in `jobs` forked processes that take the next job when they
/// have finished one. An exception of work(), or a signal that ends a process, affects that job only. `ended`
/// is called in this process, in no particular order. The caller must not have other threads. Throws
/// UsageError if no process can be created. After an interrupt (interruptRequested()) no further job is
/// started and `ended` is not called for the rest; returns false then.
bool runJobs(std::size_t count, int jobs, const std::function<int(std::size_t)>& work,
             const std::function<void(const JobEnd&)>& ended);

}  // namespace abstand::tune
