// How far a build is, and how to end it.
#pragma once

#include <functional>
#include <stdexcept>
#include <string_view>

namespace abstand::structure {

/// Ears and brake of a build. Both functions may be empty; they are called on the building threads.
struct BuildMonitor {
  /// Share of the work that is done (0 to 1, never falling) and a word for what is being done. One call at a
  /// time.
  std::function<void(double fraction, std::string_view phase)> progress;
  /// Asked between the blocks of the work, from several threads at once; true ends the build.
  std::function<bool()> cancelled;
};

/// The monitor ended the build; nothing of it is left.
class BuildCancelled : public std::runtime_error {
 public:
  BuildCancelled() : std::runtime_error("building was interrupted") {}
};

}  // namespace abstand::structure
