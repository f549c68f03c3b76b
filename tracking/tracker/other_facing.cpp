#include "tracking/tracker/other_facing.hpp"

#include "humanmodel/joint_covariance.hpp"
#include "tracking/tracker/turned_round.hpp"

namespace abstand::tracking {

void encloseOtherFacing(const TrackedBody& other, TrackedBody& body) {
  if (!body.found) return;
  humanmodel::SkeletonFrame& frame = body.frame;
  const bool is_opposite = other.found && !faceAlike(body.pose, other.pose);
  const humanmodel::SkeletonFrame its = is_opposite ? other.frame : flippedFacing(frame);
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    const auto joint = static_cast<humanmodel::Joint>(j);
    const Matrix3d either = humanmodel::enclosingCovariance(humanmodel::covarianceOf(frame, joint),
                                                            humanmodel::covarianceOf(its, joint));
    humanmodel::setCovariance(frame, joint, humanmodel::sumWithOffset(either, its.p[j] - frame.p[j]));
  }
}

}  // namespace abstand::tracking
