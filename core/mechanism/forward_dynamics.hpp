// Forward dynamics: accelerations from joint efforts.
#pragma once

#include "core/mechanism/inverse_dynamics.hpp"
#include "core/mechanism/mass_matrix.hpp"

namespace abstand::mechanism {

/// Scratch of forward dynamics, one per thread.
struct ForwardState {
  TreeState tree;
  MassMatrix mass;
};

/// qdd = M^-1 (efforts - C qd - g + sum of J^T w), arguments as in inverseDynamics(); empty `efforts` count
/// as 0. Returns -1, or the dof that moves no mass; then `qdd` is invalid. No allocation after the first call
/// with the same state. Leaves M factored in `state.mass`.
int forwardDynamics(const RigidTree& tree, const JointMotion& motion, std::span<const double> efforts,
                    const Loads& loads, ForwardState& state, std::span<double> qdd);

/// Kinetic (of `qd`) and potential energy (J; 0 at the base's origin) under constant gravity.
struct MechanicalEnergy {
  double kinetic{0.0}, potential{0.0};
  double total() const { return kinetic + potential; }
};
MechanicalEnergy mechanicalEnergy(const RigidTree& tree, std::span<const double> q,
                                  std::span<const double> qd, const Vector3d& gravity_B, TreeState& state);

}  // namespace abstand::mechanism
