// Robot files out: the thesis's format and URDF.
#pragma once

#include <string>
#include <vector>

#include "core/robot_file/robot.hpp"

namespace abstand::robot_file {

/// As a `.mech` file that reads back as the same robot: numbers within 1e-15 m or rad, shortest first. Every
/// frame must have DH values (toDh). Degrees and metres.
std::string mechText(const Robot& robot);

struct UrdfWritten {
  std::string text;
  /// The URDF's joint values are those of the robot times this, one factor a dof: URDF has no scale but for
  /// joints that mimic others.
  std::vector<double> scale;
};

/// As a URDF. Frames become links, called like them; a joint without a name is called NAME_joint. The root
/// link is the one frame that is fixed to the base at its pose, else a link called base. Offsets of joints go
/// into their poses. Ellipsoids and capsules, which URDF does not have, throw UsageError.
UrdfWritten urdfText(const Robot& robot);

}  // namespace abstand::robot_file
