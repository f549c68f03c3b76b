// A stranger's URDF before urdfdom reads it: checked, with the places of its links and joints.
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
  std::vector<UrdfPlace> visuals, collisions;  ///< of those in the document, in order
  std::string unread;  ///< what is wrong with the last visual that was left out; empty: none was
};

struct UrdfJointText {
  std::string name, type, parent, child;
  std::string mimic;  ///< the joint that leads it; empty: none
  UrdfPlace place;
};

/// What a URDF says, safe to hand to urdfdom.
struct UrdfText {
  std::string name;                   ///< of the robot
  std::string document;               ///< URDF again, of the elements and attributes that are read here only
  std::vector<UrdfLinkText> links;    ///< in file order
  std::vector<UrdfJointText> joints;  ///< in file order
  std::vector<std::string> warnings;  ///< `FILE:LINE:COLUMN: TEXT`
};

/// More links than any robot has; urdfdom takes down a chain of links by recursion.
inline constexpr std::size_t kMaxUrdfLinks = 2000;

/// Checks what urdfdom would report without a line, or not at all: XML, names, numbers (finite, at most 1e6
/// in size), types, limits, sizes, and that links and joints form one tree and mimic joints no ring. Elements
/// that this program does not read (transmission, gazebo, material, ...) are left out. Odd visuals, masses
/// and limits are warnings. Throws ParseError with line and column; a xacro file is named as one.
UrdfText checkUrdf(const std::string& text, const std::string& file);

}  // namespace abstand::robot_file
