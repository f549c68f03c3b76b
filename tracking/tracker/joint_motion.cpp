#include "tracking/tracker/joint_motion.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::tracking {

void JointMotion::see(double t, const humanmodel::SkeletonFrame& frame) {
  const double dt = t - last_t_;
  const bool moves = dt > 0.0 && dt < kMaxGap;
  const double kept = dt > 0.0 ? std::exp(-dt / kDecay) : 1.0;
  if (std::isnan(last_t_)) spread_.fill(kTime * kUnknown);
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    spread_[j] *= kept;
    if (moves) {
      const Vector3d velocity = (frame.p[j] - last_[j]) / dt;
      if (moved_) spread_[j] = std::max(spread_[j], kTime * (velocity - velocity_[j]).norm());
      velocity_[j] = velocity;
    }
    last_[j] = frame.p[j];
  }
  if (dt != 0.0) moved_ = moves;
  last_t_ = t;
}

void JointMotion::forget() {
  last_t_ = kNaN;
  moved_ = false;
  spread_.fill(0.0);
}

}  // namespace abstand::tracking
