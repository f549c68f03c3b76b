// Reachable set of a point with bounded speed and acceleration.
#pragma once

#include "core/config/number_rule.hpp"
#include "core/geometry/enclosing_sphere.hpp"

namespace abstand::safety {

/// Assumed bounds on the motion of a point. Default: unbounded, so that users have to state a bound. For a
/// person: 1.6 m/s walking and 2.0 m/s for a hand [ISO 13855:2010]; 20 to 50 m/s^2 for a hand's acceleration
/// [values of sara-shield's models].
struct MotionBounds {
  static constexpr const char* kName = "bounds";
  double speed{kInfinity};         ///< m/s
  double acceleration{kInfinity};  ///< m/s^2
  double position_error{0.0};      ///< m: largest error of the measured position
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

/// A motion p(s), s >= 0, is admissible for measured p0, v0 if |p(0) - p0| <= position_error, |v(0) - v0| <=
/// velocity_error, |v(s)| <= speed and |a(s)| <= acceleration. World frame, SI.
///
/// Returns a ball that contains p(t) of every admissible motion. p(t) is in the ball around p0 + v0 t with
/// radius e_p + e_v t + a t^2 / 2, and in the ball around p0 with radius e_p + speed t; the result contains
/// their intersection. If that is empty, the measured speed violates the bound; then it contains both.
/// Infinite radius if the point is unbounded. t >= 0. No allocation.
geometry::EnclosingSphere reachAt(const Vector3d& p0, const Vector3d& v0, const MotionBounds& bounds,
                                  double t) noexcept;

/// The same for p(s) of all s in [0, t].
geometry::EnclosingSphere reachWithin(const Vector3d& p0, const Vector3d& v0, const MotionBounds& bounds,
                                      double t) noexcept;

/// Upper bound (m) on the displacement of a point within t s: initial speed `speed0` m/s along a line
/// (negative: backwards), then accelerating up to the bound and keeping it. `bounds` without its errors.
/// Never negative.
double travelWithin(double speed0, const MotionBounds& bounds, double t) noexcept;

}  // namespace abstand::safety
