// Forward kinematics.
#include <cmath>

#include "core/base/error.hpp"
#include "core/mechanism/mechanism.hpp"

namespace abstand::mechanism {

void forward(const Mechanism& mechanism, std::span<const double> q, MechanismState& state) {
  ABSTAND_CHECK(mechanism.prepared && q.size() == static_cast<std::size_t>(mechanism.dof));
  const std::size_t n = mechanism.frames.size();
  if (state.X_BF.size() != n) state.X_BF.assign(n, Transform::Identity());

  for (std::size_t i = 0; i < n; ++i) {
    const auto& f = mechanism.frames[i];
    Transform& X_BF = state.X_BF[i];
    if (f.parent < 0)
      X_BF = f.X_PJ;
    else
      X_BF = state.X_BF[static_cast<std::size_t>(f.parent)] * f.X_PJ;
    if (f.type == JointType::kFixed) continue;
    const double value = f.offset + (f.dof < 0 ? 0.0 : f.scale * q[static_cast<std::size_t>(f.dof)]);
    if (f.type == JointType::kPrismatic) {
      X_BF.translation() += value * (X_BF.linear() * f.axis);
    } else if (f.axis != Vector3d::UnitZ()) {
      X_BF.linear() *= Eigen::AngleAxisd(value, f.axis).toRotationMatrix();
    } else {
      const double c = std::cos(value), s = std::sin(value);
      const Vector3d x_B = X_BF.linear().col(0), y_B = X_BF.linear().col(1);
      X_BF.linear().col(0) = c * x_B + s * y_B;
      X_BF.linear().col(1) = c * y_B - s * x_B;
    }
  }
}

}  // namespace abstand::mechanism
