// Records which files this run has read, so that no output overwrites one of them.
#pragma once

#include <filesystem>

namespace abstand {

/// Starts recording inputs. Called by the command line; not by the window, which saves over files that it
/// opened.
void keepInputLog();

/// Records a file as an input; links are followed. Any thread. No effect before keepInputLog().
void noteInput(const std::filesystem::path& file);

/// True if the file that `name` refers to was read.
bool isInput(const std::filesystem::path& file);

/// Suspends recording while it exists: for reading an output file whose foreign content is kept.
class InputLogPause {
 public:
  InputLogPause();
  ~InputLogPause();
  InputLogPause(const InputLogPause&) = delete;
  InputLogPause& operator=(const InputLogPause&) = delete;
};

}  // namespace abstand
