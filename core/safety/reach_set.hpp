// Where a point can be some time from now, whatever it does within bounds on its speed and acceleration.
#pragma once

#include "core/config/number_rule.hpp"
#include "core/geometry/enclosing_sphere.hpp"

namespace abstand::safety {

/// What is taken for granted of a moving point. Defaults: no bound on its speed, which is never safe to rest
/// on, so that who uses it has to say one. Of a person: 1.6 m/s walking and 2.0 m/s for a hand [ISO 13855];
/// 20 to 50 m/s^2 for a hand's acceleration [as sara-shield's models use].
struct MotionBounds {
  static constexpr const char* kName = "bounds";
  double speed{kInfinity};         ///< m/s
  double acceleration{kInfinity};  ///< m/s^2
  double position_error{0.0};      ///< m: the point is at most so far from where it was measured
  double velocity_error{0.0};      ///< m/s, of the measured velocity

  template <class Self, class Visit>
  static void eachNumber(Self& o, Visit visit) {
    visit("speed", o.speed, config::NumberRule{0.0, kInfinity, "m/s"});
    visit("acceleration", o.acceleration, config::NumberRule{0.0, kInfinity, "m/s^2"});
    visit("position_error", o.position_error, config::NumberRule{0.0, 1e3, "m"});
    visit("velocity_error", o.velocity_error, config::NumberRule{0.0, 1e3, "m/s"});
  }
  void validate() const { config::requireNumbers(*this); }  ///< throws UsageError
};

/// A motion p(s), s >= 0, is admissible for a measured p0, v0 when |p(0) - p0| <= position_error,
/// |v(0) - v0| <= velocity_error, |v(s)| <= speed and |a(s)| <= acceleration. World frame, SI.
///
/// A ball that holds p(t) of every admissible motion: p(t) is in the ball about the ballistic point p0 + v0 t
/// with radius e_p + e_v t + a t^2 / 2, and in the ball about p0 with radius e_p + speed t; the result holds
/// the part that they share. Where they share nothing, the measured speed breaks the bound; then it holds
/// both. Radius infinite where nothing bounds the point. t >= 0. No allocation.
geometry::EnclosingSphere reachAt(const Vector3d& p0, const Vector3d& v0, const MotionBounds& bounds,
                                  double t) noexcept;

/// The same for p(s) of all s in [0, t] at once.
geometry::EnclosingSphere reachWithin(const Vector3d& p0, const Vector3d& v0, const MotionBounds& bounds,
                                      double t) noexcept;

/// The farthest (m) that a point gets from where it is within t s, when it goes at `speed0` m/s at first
/// along a line (negative: backwards), and is bounded by `bounds` without its errors: it speeds up to the
/// bound and keeps it. Never negative.
double travelWithin(double speed0, const MotionBounds& bounds, double t) noexcept;

}  // namespace abstand::safety
