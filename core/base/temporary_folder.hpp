// Temporary folder with the lifetime of an object.
#pragma once

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "core/base/write_error.hpp"

namespace abstand {

/// Created in the system's temporary folder, readable by this user only; removed with its content by the
/// destructor.
class TemporaryFolder {
 public:
  /// Throws WriteError.
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "abstand-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw WriteError(name, errno);
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ec;
    std::filesystem::remove_all(path_, ec);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace abstand
