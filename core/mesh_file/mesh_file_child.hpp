// Work that may crash or never end, in a process of its own; internal to mesh_file.
#pragma once

#include <functional>
#include <string>

namespace abstand::mesh_file {

/// What became of the child.
struct ChildAnswer {
  bool finished{false};  ///< it ended by itself and said all it had to say
  std::string bytes;     ///< what `work` returned
  int signal{0};         ///< what ended it otherwise, 0 for an exit code
};

/// Runs `work` in a forked child with limits on time (s of processor) and memory (bytes), its output and
/// errors silenced, and gives what it returned. A crash, an endless loop or an absurd allocation ends the
/// child alone. `work` must need no thread. Throws std::runtime_error when no child can be made.
ChildAnswer runInChild(const std::function<std::string()>& work, unsigned max_seconds, std::size_t max_bytes);

}  // namespace abstand::mesh_file
