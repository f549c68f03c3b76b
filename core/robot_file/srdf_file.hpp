// SRDF: link pairs whose collision check is disabled, for a URDF.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/error.hpp"

namespace abstand::robot_file {

/// `<disable_collisions link1="A" link2="B" reason="..."/>`.
struct DisabledPair {
  std::string link1, link2, reason;
  SourcePos pos;
};

struct Srdf {
  std::string robot;  ///< name of the robot
  std::vector<DisabledPair> disabled;
};

/// Reads the disabled pairs; other MoveIt content (groups, states, ...) is ignored. Throws ParseError with
/// line and column.
Srdf parseSrdf(const std::string& text, const std::string& file);
Srdf loadSrdf(const std::filesystem::path& file);

/// SRDF text with the name and the disabled pairs only.
std::string srdfText(const Srdf& srdf);

/// Replaces, in the SRDF text `old`, the disabled pairs with the reasons Adjacent, Never, Always and Default,
/// which a sampling of the joint space had written, by those of `srdf`. Everything else is kept byte for
/// byte: groups, states, end effectors, comments, and pairs disabled for another reason, which are not
/// repeated. Throws ParseError if `old` is not an SRDF or belongs to a robot of another name.
std::string mergedSrdfText(const std::string& old, const std::string& file, const Srdf& srdf);

}  // namespace abstand::robot_file
