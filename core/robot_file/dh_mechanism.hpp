// Converts any robot to Denavit-Hartenberg parameters.
#pragma once

#include "core/robot_file/dh_rows.hpp"
#include "core/robot_file/robot.hpp"

namespace abstand::robot_file {

/// The same robot with frames by the modified Denavit-Hartenberg convention: for every joint a frame with its
/// z axis on the joint axis, and every frame of `robot`, with its name, at the same pose.
///
/// A joint keeps its frame if the next joint is one row away from it; otherwise its frame is moved to the
/// common normal with the next joint, so that a chain of joints takes one row each. Extra fixed frames are
/// inserted where one row is not enough: at the base, at branches, before nearly parallel axes, and for
/// frames that are not joint frames. A rotated joint frame changes offsets and limits by a constant, so the
/// same q gives the same posture.
Robot toDh(const Robot& robot, const DhTolerance& tolerance = {});

/// Largest deviation between frames of two robots with the same names and joints.
struct PostureResidual {
  int postures{0};
  double position{0.0};  ///< m, largest
  double angle{0.0};     ///< rad, largest
  std::string frame;     ///< frame with the largest position difference
};

/// Deviation over random postures within the limits of `a`, with a fixed seed. Frames missing in `b` are
/// ignored. q of `b` is q of `a` times `scale_b`, one factor for each dof; empty: all 1.
PostureResidual postureResidual(const mechanism::Mechanism& a, const mechanism::Mechanism& b, int postures,
                                const std::vector<double>& scale_b = {});

}  // namespace abstand::robot_file
