// Separating direction of a pair, and the joints' influence on its distance.
#pragma once

#include <span>

#include "core/mechanism/mechanism.hpp"
#include "core/query/pair_query.hpp"

namespace abstand::control {

/// Unit vector (world) from B to A along which the bodies separate: (witness_a - witness_b) / distance, which
/// keeps its sense inside, where the distance is negative. If the witness points coincide within rounding:
/// the direction of the force on A; without a force, or for an empty result, `otherwise`.
Vector3d partingDirection(const query::PairResult& result,
                          const Vector3d& otherwise = Vector3d::Zero()) noexcept;

/// A point of frame `frame`'s body and a unit vector there, in the mechanism's base frame.
struct LinkPoint {
  int frame;
  Vector3d p_B, n_B;
};

/// Adds `sign` times d(distance)/dq of a point of frame `frame`'s body to `row` (size dof; m/rad, or 1 for
/// prismatic joints): J_p^T n, with n and p in the mechanism's base frame. With sign +1 for a link that is A
/// and -1 for a link that is B of the same mechanism, the row times qd is the rate of the distance caused by
/// the mechanism. First order: exact as long as the surfaces are smooth at the nearest points.
void addDistanceRow(const mechanism::Mechanism& mechanism, const mechanism::MechanismState& state,
                    const LinkPoint& point, double sign, std::span<double> row) noexcept;

/// m/s, upper bound on the speed along the unit vector n of any point of a body within `sphere_W`. `twist`:
/// of the body at the point `p_W`, world axes.
double fastestAlong(const Vector3d& n, const Twist& twist, const Vector3d& p_W,
                    const geometry::EnclosingSphere& sphere_W) noexcept;

}  // namespace abstand::control
