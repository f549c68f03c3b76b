// SRDF, the file beside a URDF that says which links need not be checked against each other.
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
  std::string robot;  ///< its name
  std::vector<DisabledPair> disabled;
};

/// Reads the disabled pairs; groups, states and whatever else MoveIt keeps there are passed over. Throws
/// ParseError with line and column.
Srdf parseSrdf(const std::string& text, const std::string& file);
Srdf loadSrdf(const std::filesystem::path& file);

/// Only the name and the disabled pairs.
std::string srdfText(const Srdf& srdf);

/// The text of an SRDF with the disabled pairs of `srdf` in place of those that a sampling of the joint space
/// wrote before (reasons Adjacent, Never, Always, Default). Everything else stays byte for byte: groups,
/// states, end effectors, comments, and pairs disabled for another reason, which `srdf` does not repeat.
/// Throws ParseError for what is no SRDF and for one of a robot of another name.
std::string mergedSrdfText(const std::string& old, const std::string& file, const Srdf& srdf);

}  // namespace abstand::robot_file
