// A person on a chair, in closed form.
#pragma once

#include "tracking/body/body_rig.hpp"

namespace abstand::tracking {

/// Thighs level, calves upright, the soles on the floor; faces +x. `swing` (rad): of both hips about the
/// vertical axis, the left one to the right and the right one to the left.
inline RigPose seatedPose(const BodyRig& rig, double swing = 0.0) {
  RigPose pose;
  const double knee = rig[RigSegment::kFootLeft].p_parent.norm();
  pose.X_WP.translation() = Vector3d(0.0, 0.0, knee + 0.08);
  for (const auto& [thigh, calf, side] :
       {std::tuple{RigSegment::kThighLeft, RigSegment::kCalfLeft, 1.0},
        std::tuple{RigSegment::kThighRight, RigSegment::kCalfRight, -1.0}}) {
    pose.R_PS[index(thigh)] = Eigen::AngleAxisd(-side * swing, Vector3d::UnitZ()) *
                              Eigen::AngleAxisd(-0.5 * kPi, Vector3d::UnitY());
    pose.angle[index(calf)][0] = 0.5 * kPi;
  }
  return pose;
}

inline RigPlacement seatedPlacement(const BodyRig& rig, double swing = 0.0) {
  RigPlacement X_WS;
  place(rig, seatedPose(rig, swing), X_WS);
  return X_WS;
}

struct SeatedPerson {
  BodyRig rig = makeRig(humanmodel::makeHuman({}));
  RigPlacement X_WS = seatedPlacement(rig);

  /// m, world.
  Vector3d jointAt(humanmodel::Joint joint) const { return jointPosition(rig, X_WS, joint); }
};

}  // namespace abstand::tracking
