// A set of output files that appears completely or not at all.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace abstand {

/// Files are written into a staging folder beside the final one (or inside it, if it exists already) and
/// moved by commit(). Without commit() nothing is left behind, and folders that were created are removed.
/// Other files in an existing folder are kept. Links, devices and pipes under a final name are handled as in
/// OutputFile. An input of this run (input_log.hpp) is replaced only by identical bytes.
class OutputFolder {
 public:
  /// Throws UsageError if the folder cannot be created or is not a folder, WriteError if the disk is full.
  explicit OutputFolder(const std::filesystem::path& folder);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Path to write the file `name` (without folders) to. Throws UsageError for a name given before, and if
  /// the final name cannot be written.
  std::filesystem::path place(const std::string& name);

  /// Throws UsageError and WriteError; then no file of the set has appeared, unless the system fails between
  /// two renames.
  void commit();

 private:
  std::filesystem::path name_, folder_, staging_;
  std::vector<std::filesystem::path> made_;  ///< folders that this object created, outermost first
  std::set<std::string> files_;
  bool existed_{false}, committed_{false};
};

}  // namespace abstand
