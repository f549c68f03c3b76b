#include "core/control/pair_direction.hpp"

#include <cmath>

namespace abstand::control {
namespace {

// m; nearer witness points coincide within the rounding of coordinates of some metres.
constexpr double kOne = 1e-9;

}  // namespace

Vector3d partingDirection(const query::PairResult& result, const Vector3d& otherwise) noexcept {
  const Vector3d apart = result.witness_a - result.witness_b;
  const double length = apart.norm();
  if (length > kOne) return result.distance < 0.0 ? Vector3d(-apart / length) : Vector3d(apart / length);
  const double force = result.force_a.norm();
  return force > 0.0 ? Vector3d(result.force_a / force) : otherwise;
}

void addDistanceRow(const mechanism::Mechanism& mechanism, const mechanism::MechanismState& state,
                    const LinkPoint& point, double sign, std::span<double> row) noexcept {
  // The joint efforts of a unit force along n are d(distance)/dq.
  if (point.frame >= 0)
    mechanism::addJointEfforts(mechanism, state, point.frame, point.p_B, {sign * point.n_B, Vector3d::Zero()},
                               row);
}

double fastestAlong(const Vector3d& n, const Twist& twist, const Vector3d& p_W,
                    const geometry::EnclosingSphere& sphere_W) noexcept {
  const Vector3d v = twist.linear + twist.angular.cross(Vector3d(sphere_W.centre - p_W));
  return n.dot(v) + sphere_W.radius * n.cross(twist.angular).norm();
}

}  // namespace abstand::control
