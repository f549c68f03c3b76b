// Where tests find files.
#pragma once

#include <filesystem>
#include <string>

namespace abstand::testing {

/// A file of the project, by its path from the project's root.
std::filesystem::path projectFile(const std::string& relative);

/// A file of the collection of real recordings and robots that may lie beside the project
/// (../shared/data). Tests that need it skip where it is absent: `if (!exists(p)) GTEST_SKIP() << p;`
std::filesystem::path sharedData(const std::string& relative);

/// A capture of the Debian package assimp-testmodels; tests skip where it is absent.
std::filesystem::path debianBvh(const std::string& name);

/// A fresh folder that is removed when the object dies.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }
  /// Writes a file into the folder and gives its path.
  std::filesystem::path write(const std::string& name, const std::string& content) const;

 private:
  std::filesystem::path path_;
};

}  // namespace abstand::testing
