// A set of files that appears whole or not at all.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace abstand {

/// A folder of outputs. Files are written into a folder of their own beside the final one (or inside, where
/// that exists already) and moved at commit(); without commit() nothing is left behind, and folders that were
/// made are removed again. Files of other names that are in the folder already stay. Links, devices and pipes
/// under a final name are treated as by OutputFile. An input of this run (input_log.hpp) is
/// replaced by the same bytes only.
class OutputFolder {
 public:
  /// Throws UsageError when the folder cannot be made or is none, WriteError when the disk is full.
  explicit OutputFolder(const std::filesystem::path& folder);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Where to write the file of that name (without folders). Throws UsageError for a name that was given
  /// before and where the final name cannot be written.
  std::filesystem::path place(const std::string& name);

  /// Throws UsageError and WriteError; then no file of the set has appeared, unless the system fails between
  /// two renames.
  void commit();

 private:
  std::filesystem::path name_, folder_, staging_;
  std::vector<std::filesystem::path> made_;  ///< folders that this made, outermost first
  std::set<std::string> files_;
  bool existed_{false}, committed_{false};
};

}  // namespace abstand
