// Do the links and joints of a URDF form one tree? Internal to its reader.
#pragma once

#include "core/robot_file/urdf_text.hpp"

namespace abstand::robot_file {

/// Throws ParseError for joints between links that are not there, a link with two parents, a ring, more than
/// one root, and for mimic joints that follow an unknown joint, one of several values, or each other in a
/// ring.
void checkUrdfTree(const UrdfText& urdf, const std::string& file);

}  // namespace abstand::robot_file
