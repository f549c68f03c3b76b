// A folder that lives as long as an object.
#pragma once

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "core/base/write_error.hpp"

namespace abstand {

/// In the system's folder for temporary files, for this user alone; removed at the end with what it holds.
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
