// Effective (reflected) mass at a frame.
#pragma once

#include "core/mechanism/mass_matrix.hpp"

namespace abstand::mechanism {

/// A mechanism at the q of `state`, with the factored mass matrix there.
struct PostureMass {
  const RigidTree& tree;
  const TreeState& state;
  const MassMatrix& mass;
};

/// w^T J M^-1 J^T w: how fast a body gives way to a wrench, in the wrench's own direction, per unit of its
/// size. `w`: base axes, torque about `p_B`, on body `body` (-1, the base: 0). For the q of `state`, whose
/// `mass` is factored. `work`: size dof. No allocation.
double mobility(const PostureMass& m, int body, const Vector3d& p_B, const Wrench& w, std::span<double> work);

/// Mass (kg) that the mechanism puts against a force at the point `p_B` of frame `frame` (index) along the
/// unit vector `n_B`, joints free: 1 / (n^T J M^-1 J^T n) [Khatib 1995, Inertial properties in robotic
/// manipulation]. What ISO/TS 15066 estimates by half the moving mass plus the load. Infinity where no joint
/// can give way (then the robot is a wall). For the q of `state`, whose `mass` is factored. `work`: size dof.
/// No allocation.
double effectiveMass(const PostureMass& m, int frame, const Vector3d& p_B, const Vector3d& n_B,
                     std::span<double> work);

}  // namespace abstand::mechanism
