// Exact signed distance to the shapes.
#include <algorithm>
#include <cmath>

#include "core/geometry/shape.hpp"

namespace abstand::geometry {
namespace {

/// Newton steps below this share of the unknown are rounding noise.
constexpr double kRelativeStep = 1e-15;

/// Points nearer to a plane of symmetry than this share of the semi-axis are treated as lying on it, which
/// prevents underflow of squares in the iteration.
constexpr double kOnPlane = 1e-100;

/// v / |v|, or the x axis for the zero vector, where any direction is valid.
Vector3d direction(const Vector3d& v) {
  const double largest = v.cwiseAbs().maxCoeff();
  return largest > 0.0 ? (v / largest).normalized() : Vector3d::UnitX().eval();
}

ShapeDistance distanceToBall(const Vector3d& centre, double radius, const Vector3d& p) {
  const Vector3d d = p - centre;
  return {centre + radius * direction(d), d.stableNorm() - radius};
}

ShapeDistance distance(const Sphere& s, const Vector3d& p) {
  return distanceToBall(Vector3d::Zero(), s.radius, p);
}

ShapeDistance distance(const Capsule& s, const Vector3d& p) {
  const Vector3d on_axis(0.0, 0.0, std::clamp(p.z(), -0.5 * s.length, 0.5 * s.length));
  return distanceToBall(on_axis, s.radius, p);
}

ShapeDistance distance(const Cuboid& s, const Vector3d& p) {
  const Vector3d half = 0.5 * s.size;
  Vector3d nearest = p.cwiseMax(-half).cwiseMin(half);
  if (nearest != p) return {nearest, (p - nearest).stableNorm()};
  int axis = 0;
  const double depth = (half - p.cwiseAbs()).minCoeff(&axis);
  nearest[axis] = std::copysign(half[axis], p[axis]);
  return {nearest, -depth};
}

ShapeDistance distance(const Cylinder& s, const Vector3d& p) {
  const double half = 0.5 * s.length;
  const double rho = std::hypot(p.x(), p.y());
  const double beyond_side = rho - s.radius;
  const double beyond_cap = std::abs(p.z()) - half;
  const Vector3d on_side = s.radius * direction({p.x(), p.y(), 0.0});
  const double z_cap = std::copysign(half, p.z());
  if (beyond_side > 0.0) {
    if (beyond_cap > 0.0) return {{on_side.x(), on_side.y(), z_cap}, std::hypot(beyond_side, beyond_cap)};
    return {{on_side.x(), on_side.y(), p.z()}, beyond_side};
  }
  if (beyond_cap > beyond_side) return {{p.x(), p.y(), z_cap}, beyond_cap};
  return {{on_side.x(), on_side.y(), p.z()}, beyond_side};
}

/// Sum of (w_i / (u + d_i))^2 over the entries with w_i > 0, and its derivative with respect to u.
struct Secular {
  Vector3d w, d;
  double slope{0.0};
  double operator()(double u) {
    double sum = 0.0;
    slope = 0.0;
    for (int i = 0; i < 3; ++i) {
      if (w[i] <= 0.0) continue;
      const double q = w[i] / (u + d[i]);
      sum += q * q;
      slope -= 2.0 * q * q / (u + d[i]);
    }
    return sum;
  }
};

/// The u in [low, high] at which the sum is 1; the sum is at least 1 at `low` > 0 and at most 1 at `high`.
/// Newton's method on 1 / sqrt(sum), which is nearly linear; a step that leaves the bracket or is not at most
/// half as long as the one before is replaced by the geometric mean of the bracket.
double solve(Secular& sum, double low, double high) {
  constexpr int kMaxSteps = 400;  // bisection over the full exponent range to the last bit takes 64
  double u = low;
  double last_step = kInfinity;  // relative to u
  for (int i = 0; i < kMaxSteps && high > low; ++i) {
    const double value = sum(u);
    if (value >= 1.0) low = u;
    if (value <= 1.0) high = u;
    double next = u + 2.0 * value * (1.0 - std::sqrt(value)) / sum.slope;
    double step = std::abs(next - u) / u;
    if (step <= kRelativeStep) break;
    if (!(next > low && next < high && step <= 0.5 * last_step)) {
      next = low * std::sqrt(high / low);
      step = std::abs(next - u) / u;
      if (!(next > low && next < high)) break;
    }
    last_step = step;
    u = next;
  }
  return u;
}

/// Nearest point x of x_i = r_i y_i / (s + r_i), r_i = (e_i / e_min)^2, with s the largest root of sum (r_i
/// z_i / (s + r_i))^2 = 1, z_i = y_i / e_i (Eberly, Distance from a Point to an Ellipse, an Ellipsoid, or a
/// Hyperellipsoid, section 3). The unknown here is u = s + 1, the distance from the pole, to avoid
/// cancellation for points near the medial plane.
ShapeDistance distance(const Ellipsoid& s, const Vector3d& p) {
  const Vector3d& e = s.semi_axes;
  int shortest = 0;
  const double e_min = e.minCoeff(&shortest);
  Vector3d z = p.cwiseAbs().cwiseQuotient(e);
  z = (z.array() < kOnPlane).select(0.0, z);
  Secular sum;
  double pole = 0.0;
  bool hard_case_possible = true;
  for (int i = 0; i < 3; ++i) {
    sum.d[i] = (e[i] - e_min) * (e[i] + e_min) / (e_min * e_min);
    sum.w[i] = z[i] * (1.0 + sum.d[i]);
    if (sum.d[i] > 0.0) continue;
    pole = std::hypot(pole, sum.w[i]);
    if (sum.w[i] > 0.0) hard_case_possible = false;
  }

  Vector3d x;  // nearest point divided by the semi-axes, first octant
  double u = 0.0;
  const double at_zero = hard_case_possible ? sum(0.0) : kInfinity;
  if (at_zero > 1.0) {
    // The sum is convex and decreasing: without a pole, a Newton step from 0 stays below the root.
    const double low = hard_case_possible ? (at_zero - 1.0) / -sum.slope : pole;
    const double high = std::max(low, sum.w.stableNorm());
    u = low > 0.0 ? solve(sum, low, high) : 0.0;
  }
  for (int i = 0; i < 3; ++i) x[i] = sum.w[i] > 0.0 ? sum.w[i] / (u + sum.d[i]) : 0.0;
  if (at_zero <= 1.0) x[shortest] = std::sqrt(1.0 - at_zero);
  x.stableNormalize();

  Vector3d nearest;
  for (int i = 0; i < 3; ++i) nearest[i] = std::copysign(e[i] * x[i], p[i]);
  const double apart = (p - nearest).stableNorm();
  return {nearest, z.stableNorm() < 1.0 ? -apart : apart};
}

}  // namespace

ShapeDistance distanceTo(const Shape& shape, const Vector3d& p) {
  return std::visit([&](const auto& s) { return distance(s, p); }, shape);
}

}  // namespace abstand::geometry
