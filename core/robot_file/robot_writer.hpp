// Writes robots in the thesis's format and as URDF.
#pragma once

#include <string>
#include <vector>

#include "core/robot_file/robot.hpp"

namespace abstand::robot_file {

/// A `.mech` text that reads back as the same robot: numbers within 1e-15 m or rad, with the fewest digits.
/// Every frame must have DH values (toDh). Degrees and metres.
std::string mechText(const Robot& robot);

struct UrdfWritten {
  std::string text;
  /// Joint values in the URDF are those of the robot times this factor, one for each dof: URDF has scales
  /// only for mimic joints.
  std::vector<double> scale;
};

/// URDF text. Frames become links of the same name; a joint without a name becomes NAME_joint. The root link
/// is the only frame fixed to the base at its pose, or else an added link named base. Joint offsets become
/// part of the joint poses. Throws UsageError for ellipsoids and capsules, which URDF does not have.
UrdfWritten urdfText(const Robot& robot);

}  // namespace abstand::robot_file
