// Checks that links and joints of a URDF form a tree. Internal to its reader.
#pragma once

#include "core/robot_file/urdf_text.hpp"

namespace abstand::robot_file {

/// Throws ParseError for joints with unknown links, a link with two parents, a cycle, more than one root, and
/// for mimic joints that follow an unknown joint, one with several values, or each other in a cycle.
void checkUrdfTree(const UrdfText& urdf, const std::string& file);

}  // namespace abstand::robot_file
