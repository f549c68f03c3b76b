// Resolves the name of an output: a file to replace, or a device, pipe or descriptor to write directly.
#pragma once

#include <filesystem>

namespace abstand {

/// Where the bytes of an output go.
struct OutputPlace {
  enum class Kind {
    kFile,       ///< a regular file, or nothing yet: written to a temporary file and renamed
    kSpecial,    ///< a device, a pipe or a socket: opened and written directly
    kDescriptor  ///< /dev/stdout, /dev/fd/N: written to the process's open descriptor
  };
  Kind kind{Kind::kFile};
  std::filesystem::path path;  ///< with the links followed
  int descriptor{-1};          ///< for kDescriptor
  bool exists{false};
};

/// Follows links, also to files that do not exist yet. Throws UsageError for a directory, for a cycle of
/// links and for a file in a folder that does not exist.
OutputPlace placeOfOutput(const std::filesystem::path& name);

/// True if both names lead to the same file, pipe or descriptor. False for devices such as /dev/null, which
/// accept any number of outputs.
bool isSameOutput(const std::filesystem::path& a, const std::filesystem::path& b);

/// True if the place is standard output.
bool isStandardOutput(const OutputPlace& place);

}  // namespace abstand
