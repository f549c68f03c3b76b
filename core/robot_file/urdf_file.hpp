// URDF, the robot description of ROS.
#pragma once

#include <string>

#include "core/robot_file/robot.hpp"

namespace abstand::robot_file {

/// Reads a URDF. One frame for each link, with its name, parents first; ids count from 1. Degrees of freedom
/// are the movable joints that are not mimic joints, in file order, SI; a mimic joint shares the dof of the
/// joint that it follows. Limits of a continuous joint are infinite.
///
/// A planar joint has three values: along x and y of a plane, and about its normal `axis`; x and y are those
/// of the joint's frame after the shortest rotation of z onto the axis. A floating joint has six: x, y, z,
/// then yaw, pitch, roll as in R = Rz Ry Rx. Each value except the last has a massless frame of its own,
/// named JOINT.x, JOINT.y, JOINT.z, JOINT.yaw, JOINT.pitch.
///
/// Throws ParseError with line and column (see urdf_text.hpp). `file` is used in messages.
Robot parseUrdf(const std::string& text, const std::string& file);

}  // namespace abstand::robot_file
