// Files that are written whole or not at all.
#pragma once

#include <filesystem>
#include <fstream>
#include <ostream>
#include <string_view>

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

/// Writes a whole file at once, in the same way. Throws UsageError.
void writeFile(const std::filesystem::path& file, std::string_view text);

}  // namespace abstand
