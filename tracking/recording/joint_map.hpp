// Maps names of joints in files to canonical joints: the maps in data/joint_maps, and their selection.
#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "humanmodel/joints.hpp"

namespace abstand::tracking {

/// Point of the head that a file's `head` denotes.
enum class HeadPoint : std::uint8_t { kBase, kMiddle };

/// One naming convention of skeleton files; data/joint_maps/README.md describes the file format.
struct JointMap {
  std::string name, origin, licence;
  std::filesystem::path file;
  std::vector<std::string> prefixes;  ///< optional prefixes of names, e.g. "mixamorig:"
  std::vector<std::string> required;  ///< names without which the map does not apply
  HeadPoint head{HeadPoint::kBase};
  bool of_markers{false};  ///< the points are on the skin, not in the joints
  std::array<std::vector<std::string>, humanmodel::kJointCount>
      names;  ///< for each canonical joint, in order of preference
};

/// Throws ParseError with the line for an unknown key, joint or form.
JointMap parseJointMap(std::string_view text, const std::filesystem::path& file);
JointMap loadJointMap(const std::filesystem::path& file);

/// All `*.map` files of a folder, sorted by file name. Throws ParseError if there are none.
std::vector<JointMap> loadJointMaps(const std::filesystem::path& folder);

/// Result of a map for the joints of a file.
struct JointMatch {
  std::string map;  ///< its name
  std::array<int, humanmodel::kJointCount>
      joint;                            ///< index into the file's names and, after them, `means`; -1: none
  std::vector<std::vector<int>> means;  ///< joints that are the mean of several points of the file
  HeadPoint head{HeadPoint::kBase};
  bool of_markers{false};
  int mapped{0};     ///< canonical joints found
  int specific{0};   ///< number of required names found, plus 1 with its prefix, minus 1 without
  int rank{0};       ///< sum over the found joints of their rank among the alternatives
  int not_found{0};  ///< canonical joints in the map but not in the file
};

/// Names are compared ignoring case, '_', '.', '-' versus ' ', a prefix of the map and a namespace before the
/// last ':'. A joint of the file is used for at most one canonical joint, but for any number of means ("LWRA
/// + LWRB"). Without its required names a map maps nothing.
JointMatch matchJoints(const JointMap& map, std::span<const std::string> names);

/// The map with most canonical joints; then the more specific one: more required names or a prefix, better
/// ranks, fewer not found; then the first.
JointMatch chooseJointMap(std::span<const JointMap> maps, std::span<const std::string> names);

}  // namespace abstand::tracking
