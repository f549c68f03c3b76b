#include "core/safety/body_motion.hpp"

#include <algorithm>

#include "core/math/object_motion.hpp"

namespace abstand::safety {
namespace {

// Computed speeds are rounded up by this factor.
constexpr double kUp = 1.0 + 1e-12;

}  // namespace

PoseSegment::PoseSegment(const geometry::EnclosingSphere& sphere_B, const Transform& X_0,
                         const Transform& X_1, double duration) noexcept
    : X_0_(X_0),
      centre_B_(sphere_B.centre),
      centre_W_(X_0 * centre_B_),
      velocity_(Vector3d::Zero()),
      axis_(Vector3d::UnitZ()) {
  duration_ = std::max(0.0, duration);
  rate_ = speed_ = 0.0;
  if (duration_ == 0.0) return;
  const Vector3d rotation = rotationBetween(X_0.linear(), X_1.linear());
  const double angle = rotation.norm();
  if (angle > 0.0) axis_ = rotation / angle;
  rate_ = angle / duration_;
  velocity_ = (X_1 * centre_B_ - centre_W_) / duration_;
  speed_ = (velocity_.norm() + rate_ * sphere_B.radius) * kUp;
}

Transform PoseSegment::pose(double t) noexcept {
  t = std::clamp(t, 0.0, duration_);
  Transform X = X_0_;
  X.linear() = Eigen::AngleAxisd(rate_ * t, axis_).toRotationMatrix() * Matrix3d(X_0_.linear());
  X.translation() = centre_W_ + t * velocity_ - X.linear() * centre_B_;
  return X;
}

UnknownMotion::UnknownMotion(const Transform& X_0, const Vector3d& velocity, const MotionBounds& bounds,
                             double duration) noexcept
    : X_0_(X_0), bounds_(bounds) {
  const double drifting = bounds.velocity_error * duration + 0.5 * bounds.acceleration * duration * duration;
  drifts_ = duration > 0.0 && drifting < bounds.speed * duration;
  if (drifts_) drift_ = velocity;
}

Transform UnknownMotion::pose(double t) noexcept {
  Transform X = X_0_;
  X.translation() += t * drift_;
  return X;
}

double UnknownMotion::slack(double t) const noexcept {
  if (!(t > 0.0)) return bounds_.position_error;
  const double off =
      drifts_ ? bounds_.velocity_error * t + 0.5 * bounds_.acceleration * t * t : bounds_.speed * t;
  return (bounds_.position_error + off) * kUp;
}

double UnknownMotion::speed(double, double t1) const noexcept {
  if (!drifts_) return bounds_.speed * kUp;
  return (drift_.norm() + bounds_.velocity_error + bounds_.acceleration * t1) * kUp;
}

}  // namespace abstand::safety
