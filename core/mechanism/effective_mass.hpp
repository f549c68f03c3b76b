// Effective (reflected) mass at a frame.
#pragma once

#include "core/mechanism/mass_matrix.hpp"

namespace abstand::mechanism {

/// A mechanism at the q of `state`, with its factored mass matrix there.
struct PostureMass {
  const RigidTree& tree;
  const TreeState& state;
  const MassMatrix& mass;
};

/// Mobility w^T J M^-1 J^T w: acceleration of a body along a wrench, for each unit of the wrench. `w`: base
/// axes, torque about `p_B`, on body `body` (-1, the base: 0). `work`: size dof. No allocation.
double mobility(const PostureMass& m, int body, const Vector3d& p_B, const Wrench& w, std::span<double> work);

/// Effective mass (kg) against a force at the point `p_B` of frame `frame` (index) along the unit vector
/// `n_B`, joints free: 1 / (n^T J M^-1 J^T n) [Khatib 1995, Inertial properties in robotic manipulation].
/// ISO/TS 15066:2016 estimates it by half the moving mass plus the load. Infinity if no joint can yield.
/// `work`: size dof. No allocation.
double effectiveMass(const PostureMass& m, int frame, const Vector3d& p_B, const Vector3d& n_B,
                     std::span<double> work);

}  // namespace abstand::mechanism
