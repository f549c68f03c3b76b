// Where the name of an output leads: a file that is replaced, or something that is written straight into.
#pragma once

#include <filesystem>

namespace abstand {

/// Where the bytes of an output go.
struct OutputPlace {
  enum class Kind {
    kFile,       ///< a regular file, or none yet: written beside its name and renamed
    kSpecial,    ///< a device, a pipe or a socket: opened and written straight into
    kDescriptor  ///< /dev/stdout, /dev/fd/N: written straight into what the process has open
  };
  Kind kind{Kind::kFile};
  std::filesystem::path path;  ///< with the links followed
  int descriptor{-1};          ///< of kDescriptor
  bool exists{false};
};

/// Follows links, also to what does not exist yet. Throws UsageError for a directory, for links in a circle
/// and for a file in a folder that does not exist.
OutputPlace placeOfOutput(const std::filesystem::path& name);

/// Whether both names lead to the same file, pipe or descriptor. Devices such as /dev/null take any number of
/// outputs and are never the same.
bool isSameOutput(const std::filesystem::path& a, const std::filesystem::path& b);

/// Whether the name leads to where standard output goes.
bool isStandardOutput(const OutputPlace& place);

}  // namespace abstand
