// Which way a pair parts, and what the joints have to do with it.
#pragma once

#include <span>

#include "core/mechanism/mechanism.hpp"
#include "core/query/pair_query.hpp"

namespace abstand::control {

/// Unit vector (world) from B to A along which the bodies part: (witness_a - witness_b) / distance, which
/// keeps its sense inside, where the distance is negative. Where the witnesses are one within rounding: the
/// direction of the force on A; without a force, or with a result that was never filled, `otherwise`.
Vector3d partingDirection(const query::PairResult& result,
                          const Vector3d& otherwise = Vector3d::Zero()) noexcept;

/// A point of frame `frame`'s body and a unit vector there, in the mechanism's base frame.
struct LinkPoint {
  int frame;
  Vector3d p_B, n_B;
};

/// Adds `sign` times d(distance)/dq of a point of frame `frame`'s body to `row` (size dof; m/rad or 1 for
/// prismatic joints): J_p^T n, n and p in the mechanism's base frame. With sign +1 for the link that is A and
/// -1 for the link that is B of the same mechanism, the row times qd is the rate of the distance that the
/// mechanism causes. First order: exact while the nearest points stay where the surfaces are smooth.
void addDistanceRow(const mechanism::Mechanism& mechanism, const mechanism::MechanismState& state,
                    const LinkPoint& point, double sign, std::span<double> row) noexcept;

/// m/s, along the unit vector n: no point of a body within `sphere_W` is faster that way. `twist`: of the
/// body at the point `p_W`, world axes.
double fastestAlong(const Vector3d& n, const Twist& twist, const Vector3d& p_W,
                    const geometry::EnclosingSphere& sphere_W) noexcept;

}  // namespace abstand::control
