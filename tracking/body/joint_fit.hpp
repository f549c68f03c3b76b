// A pose of the rig from the joints of a skeleton.
#pragma once

#include "tracking/body/body_solver.hpp"

namespace abstand::tracking {

struct JointFit {
  RigPose pose;
  double rms{0.0};  ///< m, over the joints that the frame has; infinite where it has none
  int steps{0};
};

/// Least squares over the joints of `frame`, from `start`, within the limits of the joints. Inferred joints
/// count a quarter. No allocation, no throw.
JointFit fitJoints(const BodyRig& rig, const humanmodel::SkeletonFrame& frame, const RigPose& start,
                   int max_steps = 60);

/// A pose to start from: standing, the pelvis on the hips of the frame (else on the mean of its joints) and
/// turned as they are.
RigPose startAt(const humanmodel::SkeletonFrame& frame);

}  // namespace abstand::tracking
