// URDF, the robot description of ROS.
#pragma once

#include <string>

#include "core/robot_file/robot.hpp"

namespace abstand::robot_file {

/// A frame a link, named like it, parents first; ids count from 1. Degrees of freedom are the movable joints
/// that mimic no other, in file order, in SI; a joint that mimics another shares its dof. The limits of a
/// continuous joint are infinite.
///
/// A planar joint has three values: along x and y of a plane, and about its normal, which is `axis`; x and y
/// are those of the joint's frame turned the short way that takes z onto the axis. A floating joint has six:
/// x, y, z, then yaw, pitch, roll as in R = Rz Ry Rx. Each value but the last has a massless frame of its
/// own, named JOINT.x, JOINT.y, JOINT.z, JOINT.yaw, JOINT.pitch.
///
/// Throws ParseError with line and column (urdf_text.hpp says for what). `file` goes into messages.
Robot parseUrdf(const std::string& text, const std::string& file);

}  // namespace abstand::robot_file
