#include "tracking/bvh/bvh_pose.hpp"

#include <cmath>

namespace abstand::tracking {
namespace {

/// R = R * (rotation about axis by degrees): only two columns change.
void turn(Matrix3d& R, int axis, double degrees) {
  if (degrees == 0.0) return;
  const double angle = unit::deg(degrees);
  const double c = std::cos(angle), s = std::sin(angle);
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  const Vector3d column_a = R.col(a), column_b = R.col(b);
  R.col(a) = c * column_a + s * column_b;
  R.col(b) = c * column_b - s * column_a;
}

}  // namespace

BvhPose::BvhPose(const BvhHierarchy& hierarchy)
    : hierarchy_(&hierarchy), p_(hierarchy.joints.size()), R_(hierarchy.joints.size()) {
  setRest();
}

void BvhPose::setRest() {
  for (std::size_t i = 0; i < p_.size(); ++i) {
    const BvhJoint& joint = hierarchy_->joints[i];
    p_[i] = joint.offset;
    if (joint.parent >= 0) p_[i] += p_[static_cast<std::size_t>(joint.parent)];
  }
}

void BvhPose::set(std::span<const double> values) {
  ABSTAND_CHECK(values.size() == hierarchy_->channel_count);
  for (std::size_t i = 0; i < p_.size(); ++i) {
    const BvhJoint& joint = hierarchy_->joints[i];
    const bool is_root = joint.parent < 0;
    const auto parent = static_cast<std::size_t>(joint.parent);
    Vector3d t = joint.offset;
    Matrix3d& R = R_[i];
    if (is_root)
      R.setIdentity();
    else
      R = R_[parent];
    const double* value = values.data() + joint.first_channel;
    for (const BvhChannel channel : joint.channels) {
      const int c = static_cast<int>(channel);
      if (c < 3)
        t[c] = *value++;
      else
        turn(R, c - 3, *value++);
    }
    p_[i] = is_root ? t : Vector3d(p_[parent] + R_[parent] * t);
  }
}

}  // namespace abstand::tracking
