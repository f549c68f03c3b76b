// Forward dynamics by Cholesky factorisation of the mass matrix; energy.
#include "core/mechanism/forward_dynamics.hpp"

#include "core/base/error.hpp"

namespace abstand::mechanism {

int forwardDynamics(const RigidTree& tree, const JointMotion& motion, std::span<const double> efforts,
                    const Loads& loads, ForwardState& state, std::span<double> qdd) {
  ABSTAND_CHECK(efforts.empty() || efforts.size() == qdd.size());
  inverseDynamics(tree, {motion.q, motion.qd, {}}, loads, state.tree, qdd);
  for (std::size_t i = 0; i < qdd.size(); ++i) qdd[i] = (efforts.empty() ? 0.0 : efforts[i]) - qdd[i];
  massMatrix(tree, state.tree, state.mass);
  const int massless = factor(state.mass);
  if (massless < 0) solveMass(state.mass, qdd);
  return massless;
}

MechanicalEnergy mechanicalEnergy(const RigidTree& tree, std::span<const double> q,
                                  std::span<const double> qd, const Vector3d& gravity_B, TreeState& state) {
  placeBodies(tree, q, state);
  moveBodies(tree, qd, state);
  MechanicalEnergy energy;
  for (std::size_t i = 0; i < tree.bodies.size(); ++i) {
    const TreeBody& b = tree.bodies[i];
    const TreeBodyState& s = state.bodies[i];
    const Vector3d v = s.velocity + s.omega.cross(s.com_B);
    const Vector3d omega = s.R_B.transpose() * s.omega;
    energy.kinetic += 0.5 * (b.mass * v.squaredNorm() + omega.dot(b.inertia * omega));
    energy.potential -= b.mass * gravity_B.dot(s.p_B + s.com_B);
  }
  return energy;
}

}  // namespace abstand::mechanism
