// A person who was fitted to an image.
#pragma once

#include "tracking/tracker/depth_fit.hpp"

namespace abstand::tracking {

/// State of the person after an image.
struct TrackedBody {
  bool found{false};
  RigPose pose;
  RigPlacement X_WS;
  DepthMisfit misfit;
  std::array<double, kRigSegments> visible{};  ///< share of each segment that is visible at its pose
  std::array<double, kRigSegments> support{};  ///< points, DepthFit::support() of the pose
  std::array<double, kRigSegments> gap{};      ///< m, DepthFit::gaps() of the pose
  std::array<double, 2> held{};                ///< m, BodyTracker::widenHands() of the frame
  humanmodel::SkeletonFrame
      frame;  ///< joints in the world; inferred if little of their segment was seen, missing if lost
};

}  // namespace abstand::tracking
