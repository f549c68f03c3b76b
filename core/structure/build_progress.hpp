// Progress and cancellation of a build.
#pragma once

#include <functional>
#include <stdexcept>
#include <string_view>

namespace abstand::structure {

/// Callbacks of a build. Both may be empty; they are called on the building threads.
struct BuildMonitor {
  /// Share of the work done (0 to 1, never decreasing) and the name of the current phase. Calls do not
  /// overlap.
  std::function<void(double fraction, std::string_view phase)> progress;
  /// Polled between blocks of work, from several threads at once; true cancels the build.
  std::function<bool()> cancelled;
};

/// Thrown when the monitor has cancelled a build; all partial results are discarded.
class BuildCancelled : public std::runtime_error {
 public:
  BuildCancelled() : std::runtime_error("building was interrupted") {}
};

}  // namespace abstand::structure
