#include "core/base/data_folder.hpp"

#include <cstdlib>

namespace abstand {

std::filesystem::path dataFolder() {
  namespace fs = std::filesystem;
  if (const char* set = std::getenv("ABSTAND_DATA"); set != nullptr && *set != '\0') return set;
  std::error_code ec;
  const fs::path source{ABSTAND_SOURCE_DATA_FOLDER};
  if (!source.empty() && fs::is_directory(source, ec)) return source;
  const fs::path program = fs::read_symlink("/proc/self/exe", ec);
  fs::path beside = program.parent_path().parent_path() / "share" / "abstand";
  // A program that links the library may be installed anywhere.
  if (fs::path installed{ABSTAND_INSTALLED_DATA_FOLDER};
      !fs::is_directory(beside, ec) && fs::is_directory(installed, ec))
    return installed;
  return beside;
}

}  // namespace abstand
