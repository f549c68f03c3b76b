// Locates the meshes of a robot file.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/robot_file/robot.hpp"

namespace abstand::robot_file {

/// Folders searched for ROS packages, in this order.
struct PackagePaths {
  std::vector<std::filesystem::path> folders;  ///< `--package-path`
  bool environment{true};                      ///< also search the ROS environment variables, after the
                                               ///< folders
};

/// Finds the files that a robot file refers to: `package://NAME/REST` and `model://NAME/REST`,
/// `file:///PATH`, an absolute path, or one relative to the robot file's folder.
///
/// A package is searched in every folder P of --package-path, then of ROS_PACKAGE_PATH: as P/NAME, as P
/// itself if it has that name, and in the folders below P (four levels) that contain a package.xml; then as
/// share/NAME in the folders of AMENT_PREFIX_PATH and CMAKE_PREFIX_PATH. If nothing is found, the file is
/// searched from the robot file's folder upwards: first NAME/REST, then REST, then REST without its leading
/// folders one by one, but never the file's name alone; a relative path likewise.
///
/// One thread.
class MeshFinder {
 public:
  /// `robot_file` need not exist.
  MeshFinder(const std::filesystem::path& robot_file, PackagePaths paths);

  /// The file, or nullopt.
  std::optional<std::filesystem::path> find(const std::string& reference);
  /// "package://a: found in FOLDER" for every package found by the upward search; each once.
  const std::vector<std::string>& remarks() const { return remarks_; }

 private:
  std::optional<std::filesystem::path> inPackage(const std::string& package,
                                                 const std::filesystem::path& rest);
  std::vector<std::filesystem::path> packageFolders(const std::string& package) const;
  std::optional<std::filesystem::path> upwards(const std::filesystem::path& path, const std::string& package);

  std::filesystem::path folder_;
  PackagePaths paths_;
  std::map<std::string, std::vector<std::filesystem::path>> packages_;
  std::vector<std::string> remarks_;
};

}  // namespace abstand::robot_file
