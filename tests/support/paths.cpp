#include "tests/support/paths.hpp"

#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace abstand::testing {
namespace fs = std::filesystem;

fs::path projectFile(const std::string& relative) { return fs::path(ABSTAND_SOURCE_DIR) / relative; }

fs::path sharedData(const std::string& relative) {
  return fs::path(ABSTAND_SOURCE_DIR) / ".." / "shared" / "data" / relative;
}

fs::path debianBvh(const std::string& name) { return fs::path("/usr/share/assimp/models/BVH") / name; }

ScratchFolder::ScratchFolder() {
  std::string name = (fs::temp_directory_path() / "abstand-test-XXXXXX").string();
  if (!::mkdtemp(name.data())) throw std::runtime_error("no scratch folder");
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

fs::path ScratchFolder::write(const std::string& name, const std::string& content) const {
  std::ofstream(path_ / name, std::ios::binary) << content;
  return path_ / name;
}

}  // namespace abstand::testing
