// Files that are written whole or not at all.
#pragma once

#include <filesystem>
#include <ostream>
#include <string_view>

#include "core/base/descriptor_stream.hpp"
#include "core/base/output_place.hpp"

namespace abstand {

/// Writes beside the final name; commit() renames into place. Without commit() nothing is left behind. A link
/// is followed, and the file that it leads to is replaced. Devices, pipes, sockets, /dev/stdout and /dev/fd/N
/// are written straight into; of these what was written before an error stays written.
///
/// The constructor throws UsageError when the place cannot be written (a directory, no rights, an input of
/// this run, input_log.hpp), Interrupted when an interrupt comes while a pipe has no reader; finish() and
/// commit() throw WriteError when the disk or the reader refused something.
class OutputFile {
 public:
  explicit OutputFile(std::filesystem::path file);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  std::ostream& stream() { return out_; }
  /// Instead of stream(), for libraries that write by name: a file, empty at first, whose content becomes the
  /// output.
  const std::filesystem::path& named();

  /// Writes and checks everything but the rename, so that a set of files can be checked before the first of
  /// them appears.
  void finish();
  /// finish(), and renames.
  void commit();

 private:
  void openPart();
  void openSpecial();
  void copyNamed();
  void closeDescriptor();

  std::filesystem::path name_;  ///< as it was given
  OutputPlace place_;
  std::filesystem::path part_;   ///< beside the file; empty for what is written straight into
  std::filesystem::path named_;  ///< what a library wrote; empty: nothing
  int descriptor_{-1};
  DescriptorBuffer buffer_;
  std::ostream out_;
  bool finished_{false}, committed_{false};
};

/// Writes a whole file at once, in the same way. Throws UsageError and WriteError.
void writeFile(const std::filesystem::path& file, std::string_view text);

/// Adds to the end of a file, which it makes where there is none; all of the text or nothing. Throws
/// UsageError (an input of this run, too) and WriteError.
void appendToFile(const std::filesystem::path& file, std::string_view text);

}  // namespace abstand
