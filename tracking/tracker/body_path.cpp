#include "tracking/tracker/body_path.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::tracking {

void BodyPath::add(double t, const RigPose& pose) {
  if (points_.size() < kMaxPoses) points_.push_back({t, pose});
}

void BodyPath::turn() {
  const Matrix3d half_turn = Eigen::AngleAxisd(kPi, Vector3d::UnitZ()).toRotationMatrix();
  for (Point& point : points_) point.pose.X_WP.linear() = half_turn * point.pose.X_WP.linear().eval();
}

const BodyPath::Point* BodyPath::nearest(double t) const {
  const auto it = std::min_element(points_.begin(), points_.end(), [t](const Point& a, const Point& b) {
    return std::abs(a.t - t) < std::abs(b.t - t);
  });
  return it == points_.end() ? nullptr : &*it;
}

}  // namespace abstand::tracking
