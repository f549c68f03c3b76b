// Runs work that may crash or hang in a child process; internal to mesh_file.
#pragma once

#include <functional>
#include <string>

namespace abstand::mesh_file {

/// Result of the child process.
struct ChildAnswer {
  bool finished{false};  ///< the child exited normally and its answer is complete
  std::string bytes;     ///< what `work` returned
  int signal{0};         ///< signal that ended it, 0 for an exit code
};

/// Runs `work` in a forked child with limits on CPU time (s) and memory (bytes), standard output and error
/// silenced, and returns its result. A crash, an endless loop or an excessive allocation ends only the child.
/// `work` must not use threads. Throws std::runtime_error if the child cannot be started.
ChildAnswer runInChild(const std::function<std::string()>& work, unsigned max_seconds, std::size_t max_bytes);

}  // namespace abstand::mesh_file
