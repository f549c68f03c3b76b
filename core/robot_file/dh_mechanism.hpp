// Any robot as a Denavit-Hartenberg table.
#pragma once

#include "core/robot_file/dh_rows.hpp"
#include "core/robot_file/robot.hpp"

namespace abstand::robot_file {

/// The same robot with frames by the modified Denavit-Hartenberg convention: for every joint a frame with its
/// z axis on the joint's, and every frame of `robot` again, under its name, at the same pose.
///
/// A joint's frame is the one that the robot has there, where the next joint is one row away from it, else it
/// lies on the common normal to the next joint, so that a chain of joints takes one row each. Extra fixed
/// frames come where a row cannot do it: at the base, at branches, before nearly parallel axes, and for
/// frames that are not the joints' own. A turned joint frame changes offsets and limits by a constant, so the
/// same q gives the same posture.
Robot toDh(const Robot& robot, const DhTolerance& tolerance = {});

/// How far the frames of two robots with the same names and joints lie apart.
struct PostureResidual {
  int postures{0};
  double position{0.0};  ///< m, the largest
  double angle{0.0};     ///< rad, the largest
  std::string frame;     ///< where the position differs most
};

/// Over random postures within the limits of `a`, with a fixed seed. Frames of `a` that `b` has not are not
/// compared. q of `b` is q of `a` times `scale_b`, one factor a dof; empty: all 1.
PostureResidual postureResidual(const mechanism::Mechanism& a, const mechanism::Mechanism& b, int postures,
                                const std::vector<double>& scale_b = {});

}  // namespace abstand::robot_file
