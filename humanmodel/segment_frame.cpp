// Parallel transport and hinge blending.
#include "humanmodel/segment_frame.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::humanmodel {
namespace {

constexpr double kShortest = 1e-6;  // m; nearer joints define no direction
// sines of 8 and 20 degrees: 1 cm of noise on a forearm is 2 degrees
constexpr double kBendNoise = 0.139, kBendSure = 0.342;

double smoothStep(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace

std::optional<Vector3d> directionFrom(const Vector3d& a, const Vector3d& b) {
  const Vector3d d = b - a;
  const double length = d.norm();
  if (!(length > kShortest)) return std::nullopt;
  return d / length;
}

Vector3d carriedY(const Matrix3d& R_WP, const Vector3d& a_P, const Vector3d& b_W) {
  const Vector3d a_W = R_WP * a_P, y = R_WP.col(1);
  const Vector3d v = a_W.cross(b_W);
  const double c = a_W.dot(b_W);
  // Below this the cosine is -1 up to rounding and the axis of rotation is undefined.
  constexpr double kOpposite = 1e-12;
  if (1.0 + c < kOpposite) return y;
  // Rodrigues' formula with (1 - cos) / sin^2 written as 1 / (1 + cos)
  return y + v.cross(y) + v.cross(v.cross(y)) / (1.0 + c);
}

Vector3d turnedToHinge(const Vector3d& y_W, const Vector3d& b_W, const Vector3d& hinge_W, bool either_side) {
  const double weight = smoothStep(kBendNoise, kBendSure, hinge_W.norm());
  if (weight == 0.0) return y_W;
  const double side = either_side && hinge_W.dot(y_W) < 0.0 ? -1.0 : 1.0;
  const Vector3d x = y_W.cross(b_W);
  const double angle = weight * std::atan2(-side * hinge_W.dot(x), side * hinge_W.dot(y_W));
  return std::cos(angle) * y_W - std::sin(angle) * x;
}

Matrix3d frameAlong(const Vector3d& a_P, const Vector3d& b_W, const Vector3d& y_W) {
  const Vector3d y = (y_W - y_W.dot(b_W) * b_W).normalized();
  const Vector3d y_P = Vector3d::UnitY();
  Matrix3d from, to;
  from << a_P, y_P, a_P.cross(y_P);
  to << b_W, y, b_W.cross(y);
  return to * from.transpose();
}

}  // namespace abstand::humanmodel
