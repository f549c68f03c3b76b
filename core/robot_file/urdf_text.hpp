// Validates an untrusted URDF before urdfdom parses it, with the positions of its links and joints.
#pragma once

#include <string>
#include <vector>

namespace abstand::robot_file {

/// Line and column, from 1.
struct UrdfPlace {
  int line{0}, column{0};
};

struct UrdfLinkText {
  std::string name;
  UrdfPlace place;
  std::vector<UrdfPlace> visuals, collisions;  ///< positions of those in the document, in order
  std::string unread;  ///< problem of the last visual that was left out; empty if none was
};

struct UrdfJointText {
  std::string name, type, parent, child;
  std::string mimic;  ///< the joint that it follows; empty if it is not a mimic joint
  UrdfPlace place;
};

/// Validated content of a URDF, safe to pass to urdfdom.
struct UrdfText {
  std::string name;                   ///< of the robot
  std::string document;               ///< URDF text of the supported elements and attributes only
  std::vector<UrdfLinkText> links;    ///< in file order
  std::vector<UrdfJointText> joints;  ///< in file order
  std::vector<std::string> warnings;  ///< `FILE:LINE:COLUMN: TEXT`
};

/// Limit of links: urdfdom is recursive along a chain of links.
inline constexpr std::size_t kMaxUrdfLinks = 2000;

/// Checks what urdfdom would report without a line, or not at all: XML, names, numbers (finite, at most 1e6
/// in absolute value), types, limits, sizes, that links and joints form a tree, and that mimic joints have no
/// cycle. Unsupported elements (transmission, gazebo, material, ...) are dropped. Implausible visuals, masses
/// and limits are warnings. Throws ParseError with line and column; unexpanded xacro files get their own
/// message.
UrdfText checkUrdf(const std::string& text, const std::string& file);

}  // namespace abstand::robot_file
