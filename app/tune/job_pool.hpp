// Jobs in processes of their own, so that one that crashes ends alone.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace abstand::tune {

/// What became of a job.
struct JobEnd {
  std::size_t job{0};
  std::optional<int> answer;  ///< of work(); none where it threw or its process ended
  std::string message;        ///< why there is none: what was thrown, or the signal that ended the process
};

/// Calls work(0) ... work(count - 1), each once, in `jobs` processes that are copies of this one and take the
/// next job when they are done with one. What work() throws, and a signal that ends a process, end that job
/// alone. `ended` is called here, in no order. The caller has no other threads. Throws UsageError where no
/// process can be made. After an interrupt (interruptRequested()) no further job is begun and the rest has no
/// end; false then.
bool runJobs(std::size_t count, int jobs, const std::function<int(std::size_t)>& work,
             const std::function<void(const JobEnd&)>& ended);

}  // namespace abstand::tune
