// Jacobian of a frame, and its transpose applied to a wrench.
#include "core/base/error.hpp"
#include "core/mechanism/mechanism.hpp"

namespace abstand::mechanism {
namespace {

// Calls `visit(frame, X_BF)` for every frame with a dof from `index` down to the base.
template <class Visit>
void forEachJointBelow(const Mechanism& mechanism, const MechanismState& state, int index, Visit visit) {
  ABSTAND_CHECK(index >= 0 && static_cast<std::size_t>(index) < mechanism.frames.size());
  ABSTAND_CHECK(state.X_BF.size() == mechanism.frames.size());
  for (int i = index; i >= 0; i = mechanism.frames[static_cast<std::size_t>(i)].parent) {
    const auto& f = mechanism.frames[static_cast<std::size_t>(i)];
    if (f.dof >= 0) visit(f, state.X_BF[static_cast<std::size_t>(i)]);
  }
}

}  // namespace

void jacobian(const Mechanism& mechanism, const MechanismState& state, int index,
              Eigen::Matrix<double, 6, Eigen::Dynamic>& J) {
  J.setZero(6, mechanism.dof);
  forEachJointBelow(mechanism, state, index, [&](const MechanismFrame& f, const Transform& X_BF) {
    const Vector3d axis_B = f.scale * (X_BF.linear() * f.axis);
    if (f.type == JointType::kPrismatic) {
      J.col(f.dof).head<3>() += axis_B;
    } else {
      const Vector3d arm_B = state.X_BF[static_cast<std::size_t>(index)].translation() - X_BF.translation();
      J.col(f.dof).head<3>() += axis_B.cross(arm_B);
      J.col(f.dof).tail<3>() += axis_B;
    }
  });
}

void addJointEfforts(const Mechanism& mechanism, const MechanismState& state, int index, const Vector3d& p_B,
                     const Wrench& w, std::span<double> efforts) {
  ABSTAND_CHECK(efforts.size() == static_cast<std::size_t>(mechanism.dof));
  forEachJointBelow(mechanism, state, index, [&](const MechanismFrame& f, const Transform& X_BF) {
    const Vector3d axis_B = f.scale * (X_BF.linear() * f.axis);
    double& effort = efforts[static_cast<std::size_t>(f.dof)];
    if (f.type == JointType::kPrismatic)
      effort += axis_B.dot(w.force);
    else
      effort += axis_B.dot(w.torque + (p_B - X_BF.translation()).cross(w.force));
  });
}

}  // namespace abstand::mechanism
