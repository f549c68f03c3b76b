#include "core/robot_file/mesh_reference.hpp"

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <system_error>

namespace abstand::robot_file {
namespace {

namespace fs = std::filesystem;

// Limits of the search: depth of packages below src in a workspace, and number of folders visited.
constexpr int kDeepestPackage = 4;
constexpr int kMaxFolders = 20000;
constexpr std::size_t kLongestPath = 4096;

bool isFile(const fs::path& path) {
  std::error_code ec;
  return fs::is_regular_file(path, ec);
}

bool isFolder(const fs::path& path) {
  std::error_code ec;
  return fs::is_directory(path, ec);
}

std::vector<fs::path> foldersOf(const char* variable) {
  std::vector<fs::path> folders;
  const char* text = std::getenv(variable);
  std::string_view rest = text ? text : "";
  while (!rest.empty()) {
    const auto end = std::min(rest.find(':'), rest.size());
    if (end > 0) folders.emplace_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return folders;
}

/// Collects folders named `package` that contain a package.xml, below `root`.
void collectBelow(const fs::path& root, const std::string& package, std::vector<fs::path>& found) {
  std::error_code ec;
  int looked_at = 0;
  for (fs::recursive_directory_iterator at(root, fs::directory_options::skip_permission_denied, ec), end;
       !ec && at != end && looked_at < kMaxFolders; at.increment(ec)) {
    std::error_code type_error;
    if (!at->is_directory(type_error)) continue;
    ++looked_at;
    const std::string name = at->path().filename().string();
    if (name.starts_with('.') || at.depth() >= kDeepestPackage) at.disable_recursion_pending();
    if (name == package && isFile(at->path() / "package.xml")) found.push_back(at->path());
  }
}

}  // namespace

MeshFinder::MeshFinder(const fs::path& robot_file, PackagePaths paths) : paths_(std::move(paths)) {
  std::error_code ec;
  folder_ = fs::absolute(robot_file, ec).lexically_normal().parent_path();
}

std::vector<fs::path> MeshFinder::packageFolders(const std::string& package) const {
  std::vector<fs::path> roots = paths_.folders, found;
  if (paths_.environment)
    for (auto& folder : foldersOf("ROS_PACKAGE_PATH")) roots.push_back(std::move(folder));
  for (const auto& root : roots) {
    std::error_code ec;
    const fs::path full = fs::absolute(root, ec).lexically_normal();
    if (isFolder(full / package)) found.push_back(full / package);
    if ((full.has_filename() ? full : full.parent_path()).filename() == package && isFolder(full))
      found.push_back(full);
    collectBelow(full, package, found);
  }
  if (paths_.environment)
    for (const char* variable : {"AMENT_PREFIX_PATH", "CMAKE_PREFIX_PATH"})
      for (const auto& prefix : foldersOf(variable))
        if (isFolder(prefix / "share" / package)) found.push_back(prefix / "share" / package);
  return found;
}

std::optional<fs::path> MeshFinder::upwards(const fs::path& path, const std::string& package) {
  std::vector<fs::path> parts;
  for (const auto& part : path.lexically_normal())
    if (!part.empty() && part != "/") parts.push_back(part);
  for (std::size_t skipped = 0; skipped < parts.size() && (skipped == 0 || skipped + 1 < parts.size());
       ++skipped) {
    fs::path rest;
    for (std::size_t i = skipped; i < parts.size(); ++i) rest /= parts[i];
    for (fs::path folder = folder_;; folder = folder.parent_path()) {
      if (isFile(folder / rest)) {
        const std::string remark =
            "package://" + package + ": not on the package path, found at " + folder.string();
        if (!package.empty() && std::find(remarks_.begin(), remarks_.end(), remark) == remarks_.end())
          remarks_.push_back(remark);
        return (folder / rest).lexically_normal();
      }
      if (!folder.has_relative_path()) break;
    }
  }
  return std::nullopt;
}

std::optional<fs::path> MeshFinder::inPackage(const std::string& package, const fs::path& rest) {
  auto at = packages_.find(package);
  if (at == packages_.end()) at = packages_.emplace(package, packageFolders(package)).first;
  for (const auto& folder : at->second)
    if (isFile(folder / rest)) return (folder / rest).lexically_normal();
  return upwards(fs::path(package) / rest, package);
}

std::optional<fs::path> MeshFinder::find(const std::string& reference) {
  if (reference.empty() || reference.size() > kLongestPath) return std::nullopt;
  const std::string_view text = reference;
  for (const std::string_view scheme : {"package://", "model://"}) {
    if (!text.starts_with(scheme)) continue;
    const auto rest = text.substr(scheme.size());
    const auto slash = rest.find('/');
    if (slash == 0 || slash == std::string_view::npos || rest.substr(0, slash) == "." ||
        rest.substr(0, slash) == "..")
      return std::nullopt;
    return inPackage(std::string(rest.substr(0, slash)), fs::path(rest.substr(slash + 1)).relative_path());
  }
  const fs::path path(text.starts_with("file://") ? text.substr(7) : text);
  if (path.is_absolute()) return isFile(path) ? std::optional(path.lexically_normal()) : std::nullopt;
  if (isFile(folder_ / path)) return (folder_ / path).lexically_normal();
  return upwards(path, "");
}

}  // namespace abstand::robot_file
