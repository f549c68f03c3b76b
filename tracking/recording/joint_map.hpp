// Which joint of a file is which canonical joint: the maps in data/joint_maps, and the choice between them.
#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "humanmodel/joints.hpp"

namespace abstand::tracking {

/// Which point of the head a file's `head` is.
enum class HeadPoint : std::uint8_t { kBase, kMiddle };

/// One naming convention of skeleton files; data/joint_maps/README.md describes the file format.
struct JointMap {
  std::string name, origin, licence;
  std::filesystem::path file;
  std::vector<std::string> prefixes;  ///< that names may carry, e.g. "mixamorig:"
  std::vector<std::string> required;  ///< names without which the map does not apply
  HeadPoint head{HeadPoint::kBase};
  bool of_markers{false};  ///< the points lie on the skin, not in the joints
  std::array<std::vector<std::string>, humanmodel::kJointCount>
      names;  ///< by canonical joint, the best first
};

/// Throws ParseError with the line for an unknown key, joint or form.
JointMap parseJointMap(std::string_view text, const std::filesystem::path& file);
JointMap loadJointMap(const std::filesystem::path& file);

/// All `*.map` files of a folder, by file name. Throws ParseError when there is none.
std::vector<JointMap> loadJointMaps(const std::filesystem::path& folder);

/// What a map makes of the joints of a file.
struct JointMatch {
  std::string map;  ///< its name
  std::array<int, humanmodel::kJointCount>
      joint;                            ///< index into the file's names and, behind them, means; -1: none
  std::vector<std::vector<int>> means;  ///< joints that are the middle of several points of the file
  HeadPoint head{HeadPoint::kBase};
  bool of_markers{false};
  int mapped{0};     ///< canonical joints found
  int specific{0};   ///< required names found, 1 more with its prefix, 1 less without
  int rank{0};       ///< sum over the found of their place among the alternatives
  int not_found{0};  ///< canonical joints that the map knows and the file has not
};

/// Names are compared without regard to capitals, to '_', '.', '-' against ' ', to a prefix of the map and to
/// a namespace before the last ':'. A file joint serves one canonical joint at most, but may take part in any
/// number of means ("LWRA + LWRB"). Without its required names a map maps nothing.
JointMatch matchJoints(const JointMap& map, std::span<const std::string> names);

/// The map with most canonical joints; then the more specific: more required names or a prefix, better
/// places, fewer not found; then the first.
JointMatch chooseJointMap(std::span<const JointMap> maps, std::span<const std::string> names);

}  // namespace abstand::tracking
