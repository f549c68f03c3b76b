// Motions of one body over [0, T] with certified bounds on its speed.
#pragma once

#include "core/geometry/enclosing_sphere.hpp"
#include "core/safety/reach_set.hpp"

namespace abstand::safety {

/// Predicted motion of a body from now on. Not shared between threads: pose() may use scratch.
class BodyMotion {
 public:
  virtual ~BodyMotion() = default;
  /// Pose in the world at t s from now.
  virtual Transform pose(double t) noexcept = 0;
  /// m: largest deviation at t of any point of the body from its position by pose(t). Never decreases with t.
  virtual double slack(double t) const noexcept = 0;
  /// m/s: upper bound within [t0, t1] on the speed of any point in pose(t), plus the growth rate of slack().
  virtual double speed(double t0, double t1) const noexcept = 0;
};

/// Motion between two poses: the centre of the bounding sphere moves on a line at constant speed, the body
/// rotates about a fixed axis at a constant rate.
class PoseSegment final : public BodyMotion {
 public:
  /// @param sphere_B  contains the body
  /// @param duration  s; 0: at rest at X_0
  PoseSegment(const geometry::EnclosingSphere& sphere_B, const Transform& X_0, const Transform& X_1,
              double duration) noexcept;
  Transform pose(double t) noexcept override;
  double slack(double) const noexcept override { return 0.0; }
  double speed(double, double) const noexcept override { return speed_; }
  /// Velocity (m/s, world) at t = 0 of the point of the body that is at p_W then.
  Vector3d velocityAt(const Vector3d& p_W) const noexcept {
    return velocity_ + rate_ * axis_.cross(p_W - centre_W_);
  }

 private:
  Transform X_0_;
  Vector3d centre_B_, centre_W_, velocity_, axis_;  ///< centre_W_: at t = 0
  double rate_, duration_, speed_;
};

/// A body with known bounds only: each of its points moves admissibly (reach_set.hpp). The nominal pose is at
/// rest or moves at the measured velocity, whichever gives less slack at the end of the time.
class UnknownMotion final : public BodyMotion {
 public:
  /// @param velocity  measured, of the centre; the velocity of other points due to rotation is part of
  ///                  bounds.velocity_error (radius times the rate)
  UnknownMotion(const Transform& X_0, const Vector3d& velocity, const MotionBounds& bounds,
                double duration) noexcept;
  Transform pose(double t) noexcept override;
  double slack(double t) const noexcept override;
  double speed(double t0, double t1) const noexcept override;

 private:
  Transform X_0_;
  Vector3d drift_{Vector3d::Zero()};
  MotionBounds bounds_;
  bool drifts_;
};

}  // namespace abstand::safety
