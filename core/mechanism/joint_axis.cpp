#include "core/mechanism/joint_axis.hpp"

#include "core/base/error.hpp"

namespace abstand::mechanism {

void jointAxes(const Mechanism& mechanism, const MechanismState& state, std::span<JointAxis> axes) {
  ABSTAND_CHECK(axes.size() == static_cast<std::size_t>(mechanism.dof));
  ABSTAND_CHECK(state.X_BF.size() == mechanism.frames.size());
  for (std::size_t i = 0; i < mechanism.frames.size(); ++i) {
    const MechanismFrame& f = mechanism.frames[i];
    if (f.dof < 0 || f.mimic) continue;
    const Transform& X_BF = state.X_BF[i];
    axes[static_cast<std::size_t>(f.dof)] = {X_BF.translation(),
                                             (f.scale < 0.0 ? -1.0 : 1.0) * (X_BF.linear() * f.axis),
                                             f.type == JointType::kPrismatic};
  }
}

}  // namespace abstand::mechanism
