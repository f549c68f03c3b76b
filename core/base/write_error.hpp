// A write that the system rejected.
#pragma once

#include <stdexcept>
#include <string>

namespace abstand {

/// The disk, the device or the reader of a pipe accepted less than all bytes (exit code 4).
class WriteError : public std::runtime_error {
 public:
  /// `NAME: cannot be written whole: REASON`, where `error` is an errno value; 0: no reason is known.
  WriteError(const std::string& name, int error);
  WriteError(const std::string& name, const std::string& reason)
      : std::runtime_error(name + ": cannot be written completely: " + reason) {}
};

}  // namespace abstand
