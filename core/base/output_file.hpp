// Files that are written whole or not at all.
#pragma once

#include <filesystem>
#include <fstream>
#include <ostream>

namespace abstand {

/// Writes beside the final name; commit() renames into place. Without commit() nothing is left behind.
/// Throws UsageError when the place cannot be written.
class OutputFile {
 public:
  explicit OutputFile(std::filesystem::path file);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  std::ostream& stream() { return out_; }
  /// Flushes, checks and renames. Throws UsageError when the disk refused something.
  void commit();

 private:
  std::filesystem::path file_;
  std::filesystem::path part_;
  std::ofstream out_;
  bool committed_{false};
};

}  // namespace abstand
