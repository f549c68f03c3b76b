#include "app/cli/mesh_argument.hpp"

namespace abstand::cli {

std::filesystem::path meshArgument(const std::string& text, const robot_file::PackagePaths& packages) {
  if (text.find("://") == std::string::npos) return text;
  std::error_code ec;
  robot_file::MeshFinder finder(std::filesystem::current_path(ec) / "arguments", packages);
  if (const auto file = finder.find(text)) return *file;
  throw ParseError({text}, "found no such file, expected it in a package",
                   "give the folder that contains the package with --package-path FOLDER");
}

}  // namespace abstand::cli
