// Which files this run has read, so that no output replaces one of them.
#pragma once

#include <filesystem>

namespace abstand {

/// From now on inputs are noted. The command line does; the window, which saves what it opened, does not.
void keepInputLog();

/// A file that is read as input. Links are followed. Any thread; nothing happens unless a log is kept.
void noteInput(const std::filesystem::path& file);

/// Whether the file that the name leads to was read.
bool isInput(const std::filesystem::path& file);

/// While it lives nothing is noted: for an output that is read in order to keep what is not ours.
class InputLogPause {
 public:
  InputLogPause();
  ~InputLogPause();
  InputLogPause(const InputLogPause&) = delete;
  InputLogPause& operator=(const InputLogPause&) = delete;
};

}  // namespace abstand
