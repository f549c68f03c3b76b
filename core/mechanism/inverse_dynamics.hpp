// Inverse dynamics: joint efforts of a motion.
#pragma once

#include "core/mechanism/rigid_tree.hpp"

namespace abstand::mechanism {

/// Standard gravity, m/s^2, for a base whose z is up.
inline const Vector3d kGravity{0.0, 0.0, -9.80665};

/// Joint values and their rates; rad or m, and per second. `qd`, `qdd`: size dof, or empty for none.
struct JointMotion {
  std::span<const double> q, qd, qdd;
};

/// Forces on a mechanism other than those of its motors.
struct Loads {
  /// gravity, m/s^2, base axes; for a base that accelerates without rotation: minus that acceleration
  const Vector3d& gravity_B;
  /// External wrench on each body, in base axes, torque about the base's origin (aboutOrigin()); or empty.
  std::span<const Wrench> external;
};

/// Recursive Newton-Euler [Luh, Walker, Paul 1980, On-line computational scheme for mechanical manipulators;
/// Craig, Introduction to Robotics, 6.5; Featherstone 2008, 5.3], in base axes with moments about each body's
/// own origin:
///
///     efforts = M(q) qdd + C(q, qd) qd + g(q) - sum of J^T w over the external wrenches
///
/// `efforts`: N m or N, size dof, overwritten. Efforts of mimic joints are projected onto their dof: each
/// joint's effort times its scale, summed.
///
/// Leaves poses, angular velocities and accelerations of the bodies in `state`; accelerations include the
/// gravity term. O(bodies); no allocation after the first call with the same state.
void inverseDynamics(const RigidTree& tree, const JointMotion& motion, const Loads& loads, TreeState& state,
                     std::span<double> efforts);

/// g(q): efforts that hold the mechanism at rest.
inline void gravityEfforts(const RigidTree& tree, std::span<const double> q, const Vector3d& gravity_B,
                           TreeState& state, std::span<double> efforts) {
  inverseDynamics(tree, {q, {}, {}}, {gravity_B, {}}, state, efforts);
}

/// C(q, qd) qd + g(q): efforts of zero acceleration.
inline void biasEfforts(const RigidTree& tree, std::span<const double> q, std::span<const double> qd,
                        const Vector3d& gravity_B, TreeState& state, std::span<double> efforts) {
  inverseDynamics(tree, {q, qd, {}}, {gravity_B, {}}, state, efforts);
}

/// The wrench `w` about the point `p_B`, expressed about the base's origin.
inline Wrench aboutOrigin(const Wrench& w, const Vector3d& p_B) {
  return {w.force, w.torque + p_B.cross(w.force)};
}

}  // namespace abstand::mechanism
