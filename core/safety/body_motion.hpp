// Motions of one body over [0, T], with what is certain about their speed.
#pragma once

#include "core/geometry/enclosing_sphere.hpp"
#include "core/safety/reach_set.hpp"

namespace abstand::safety {

/// What a body does from now on. Not shared between threads: pose() may use scratch.
class BodyMotion {
 public:
  virtual ~BodyMotion() = default;
  /// In the world, t s from now.
  virtual Transform pose(double t) noexcept = 0;
  /// m: no point of the body is farther at t from where pose(t) puts it. Never falls with t.
  virtual double slack(double t) const noexcept = 0;
  /// m/s: within [t0, t1] no point moves faster with pose(t), the growth of slack() added.
  virtual double speed(double t0, double t1) const noexcept = 0;
};

/// From one pose to another: the centre of the bounding sphere on a line at constant speed, the body turning
/// about one axis at a constant rate.
class PoseSegment final : public BodyMotion {
 public:
  /// @param sphere_B  holds the body
  /// @param duration  s; 0: stands at X_0
  PoseSegment(const geometry::EnclosingSphere& sphere_B, const Transform& X_0, const Transform& X_1,
              double duration) noexcept;
  Transform pose(double t) noexcept override;
  double slack(double) const noexcept override { return 0.0; }
  double speed(double, double) const noexcept override { return speed_; }
  /// m/s, in the world, at t = 0, of the body's point that is at p_W then.
  Vector3d velocityAt(const Vector3d& p_W) const noexcept;

 private:
  Transform X_0_;
  Vector3d centre_B_, velocity_, axis_;
  double rate_, duration_, speed_;
};

/// A body of which only bounds are known: each of its points moves admissibly (reach_set.hpp). It stands or
/// drifts at the measured velocity, whichever leaves less slack at the end of the time.
class UnknownMotion final : public BodyMotion {
 public:
  /// @param velocity  of the centre, measured; how fast other points go differently by turning belongs into
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
