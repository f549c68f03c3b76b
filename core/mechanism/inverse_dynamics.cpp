// Recursive Newton-Euler.
#include "core/mechanism/inverse_dynamics.hpp"

#include <algorithm>

#include "core/base/error.hpp"

namespace abstand::mechanism {

void inverseDynamics(const RigidTree& tree, const JointMotion& motion, const Loads& loads, TreeState& state,
                     std::span<double> efforts) {
  const auto& [q, qd, qdd] = motion;
  const std::span<const Wrench> external = loads.external;
  const auto dof = static_cast<std::size_t>(tree.dof);
  const std::size_t n = tree.bodies.size();
  ABSTAND_CHECK((qd.empty() || qd.size() == dof) && (qdd.empty() || qdd.size() == dof));
  ABSTAND_CHECK((external.empty() || external.size() == n) && efforts.size() == dof);
  placeBodies(tree, q, state);

  // Outward pass: motion, and the wrench that each body needs alone. Gravity is an upward acceleration of the
  // base.
  const Vector3d lift_B = -loads.gravity_B;
  for (std::size_t i = 0; i < n; ++i) {
    const TreeBody& b = tree.bodies[i];
    TreeBodyState& s = state.bodies[i];
    const auto k = static_cast<std::size_t>(b.dof);
    const double rate = qd.empty() ? 0.0 : qd[k];
    const double change = qdd.empty() ? 0.0 : qdd[k];
    if (b.parent < 0) {
      s.omega.setZero();
      s.alpha.setZero();
      s.acceleration = lift_B;
    } else {
      const TreeBodyState& p = state.bodies[static_cast<std::size_t>(b.parent)];
      s.omega = p.omega;
      s.alpha = p.alpha;
      s.acceleration = p.acceleration + p.alpha.cross(s.arm_B) + p.omega.cross(p.omega.cross(s.arm_B));
    }
    if (b.prismatic) {
      s.acceleration += change * s.axis_B + 2.0 * rate * s.omega.cross(s.axis_B);
    } else {
      s.alpha += change * s.axis_B + rate * s.omega.cross(s.axis_B);
      s.omega += rate * s.axis_B;
    }
    s.force = b.mass * (s.acceleration + s.alpha.cross(s.com_B) + s.omega.cross(s.omega.cross(s.com_B)));
    const Vector3d omega = s.R_B.transpose() * s.omega, alpha = s.R_B.transpose() * s.alpha;
    const Vector3d turning = b.inertia * alpha + omega.cross(b.inertia * omega);
    s.moment = s.R_B * turning + s.com_B.cross(s.force);
    if (!external.empty()) {
      s.force -= external[i].force;
      s.moment -= external[i].torque - s.p_B.cross(external[i].force);
    }
  }

  // Inward pass: every joint carries its body and all bodies beyond.
  std::fill(efforts.begin(), efforts.end(), 0.0);
  for (std::size_t i = n; i-- > 0;) {
    const TreeBody& b = tree.bodies[i];
    const TreeBodyState& s = state.bodies[i];
    efforts[static_cast<std::size_t>(b.dof)] += s.axis_B.dot(b.prismatic ? s.force : s.moment);
    if (b.parent < 0) continue;
    TreeBodyState& p = state.bodies[static_cast<std::size_t>(b.parent)];
    p.force += s.force;
    p.moment += s.moment + s.arm_B.cross(s.force);
  }
}

}  // namespace abstand::mechanism
