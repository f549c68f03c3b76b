// Fits a pose of the rig to the joints of a skeleton.
#pragma once

#include "tracking/body/body_solver.hpp"

namespace abstand::tracking {

struct JointFit {
  RigPose pose;
  double rms{0.0};  ///< m, over the joints of the frame; infinite if it has none
  int steps{0};
};

/// Least squares over the joints of `frame`, starting from `start`, within the joint limits. Inferred joints
/// have a weight of 1/4. No allocation, no throw.
JointFit fitJoints(const BodyRig& rig, const humanmodel::SkeletonFrame& frame, const RigPose& start,
                   int max_steps = 60);

/// Start pose: standing, the pelvis at the hips of the frame (otherwise at the mean of its joints) and
/// oriented like them.
RigPose startAt(const humanmodel::SkeletonFrame& frame);

}  // namespace abstand::tracking
