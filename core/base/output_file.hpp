// Output files that are written completely or not at all.
#pragma once

#include <filesystem>
#include <ostream>
#include <string_view>

#include "core/base/descriptor_stream.hpp"
#include "core/base/output_place.hpp"

namespace abstand {

/// Writes a temporary file beside the final name; commit() renames it. Without commit() nothing is left
/// behind. Links are followed and their target is replaced. Devices, pipes, sockets, /dev/stdout and
/// /dev/fd/N are written directly; what was written to them before an error stays written.
///
/// The constructor throws UsageError if the place cannot be written (a directory, no permission, an input of
/// this run, see input_log.hpp), and Interrupted on an interrupt while a pipe has no reader. finish() and
/// commit() throw WriteError if the disk or the reader rejects data.
class OutputFile {
 public:
  explicit OutputFile(std::filesystem::path file);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  std::ostream& stream() { return out_; }
  /// For libraries that write by file name, instead of stream(): an empty file whose content becomes the
  /// output.
  const std::filesystem::path& named();

  /// Writes and checks everything except the rename, so that a set of files can be checked before the first
  /// of them appears.
  void finish();
  /// finish(), then the rename.
  void commit();

 private:
  void openPart();
  void openSpecial();
  void copyNamed();
  void closeDescriptor();

  std::filesystem::path name_;  ///< as given
  OutputPlace place_;
  std::filesystem::path part_;   ///< temporary file beside the final one; empty if the target is written
                                 ///< directly
  std::filesystem::path named_;  ///< file that a library writes; empty: none
  int descriptor_{-1};
  DescriptorBuffer buffer_;
  std::ostream out_;
  bool finished_{false}, committed_{false};
};

/// Writes a whole file at once, like OutputFile. Throws UsageError and WriteError.
void writeFile(const std::filesystem::path& file, std::string_view text);

/// Appends to a file, which is created if it does not exist: all of the text or nothing. Throws UsageError
/// (also for an input of this run) and WriteError.
void appendToFile(const std::filesystem::path& file, std::string_view text);

}  // namespace abstand
