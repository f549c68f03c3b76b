#include "core/safety/reach_set.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::safety {
namespace {

// Some hundred rounding errors of a double: radii are enlarged by this share of the values they are computed
// from.
constexpr double kRounding = 1e-14;

geometry::EnclosingSphere widened(const Vector3d& centre, double radius) {
  return {centre, radius + kRounding * (centre.norm() + radius)};
}

geometry::EnclosingSphere aroundBoth(const geometry::EnclosingSphere& a, const geometry::EnclosingSphere& b,
                                     const Vector3d& direction, double gap) {
  const double radius = (a.radius + gap + b.radius) / 2.0;
  return widened(a.centre + (radius - a.radius) * direction, radius);
}

/// A ball around the intersection of two balls.
geometry::EnclosingSphere aroundShared(const geometry::EnclosingSphere& a,
                                       const geometry::EnclosingSphere& b) {
  const geometry::EnclosingSphere& smaller = a.radius <= b.radius ? a : b;
  const Vector3d between = b.centre - a.centre;
  const double gap = between.norm();
  if (!(a.radius < kInfinity && b.radius < kInfinity) || gap == 0.0) return smaller;
  if (gap > a.radius + b.radius) return aroundBoth(a, b, between / gap, gap);
  // The spheres intersect in the plane at distance x from a's centre.
  const double x = (gap * gap + (a.radius - b.radius) * (a.radius + b.radius)) / (2.0 * gap);
  if (x <= 0.0 || x >= gap) return smaller;
  const double radius = std::sqrt(std::max(0.0, (a.radius - x) * (a.radius + x)));
  // The intersection circle is only known up to rounding of the radii.
  const double slack = std::sqrt(kRounding) * smaller.radius;
  if (radius + slack >= smaller.radius) return smaller;
  return widened(a.centre + x / gap * between, radius + slack);
}

}  // namespace

geometry::EnclosingSphere reachAt(const Vector3d& p0, const Vector3d& v0, const MotionBounds& bounds,
                                  double t) noexcept {
  if (!(t > 0.0)) return widened(p0, bounds.position_error);
  const double off = bounds.position_error + bounds.velocity_error * t + 0.5 * bounds.acceleration * t * t;
  return aroundShared(widened(p0 + t * v0, off), widened(p0, bounds.position_error + bounds.speed * t));
}

geometry::EnclosingSphere reachWithin(const Vector3d& p0, const Vector3d& v0, const MotionBounds& bounds,
                                      double t) noexcept {
  if (!(t > 0.0)) return widened(p0, bounds.position_error);
  const double off = bounds.position_error + bounds.velocity_error * t + 0.5 * bounds.acceleration * t * t;
  return aroundShared(widened(p0 + 0.5 * t * v0, 0.5 * t * v0.norm() + off),
                      widened(p0, bounds.position_error + bounds.speed * t));
}

double travelWithin(double speed0, const MotionBounds& bounds, double t) noexcept {
  if (!(t > 0.0)) return 0.0;
  if (bounds.acceleration == kInfinity) return bounds.speed * t;
  const double v0 = std::min(speed0, bounds.speed), a = bounds.acceleration;
  const double rising = a > 0.0 ? std::min(t, (bounds.speed - v0) / a) : t;
  return std::max(0.0, v0 * rising + 0.5 * a * rising * rising + (v0 + a * rising) * (t - rising));
}

}  // namespace abstand::safety
