// Constant parts of a mechanism.
#include "core/mechanism/mechanism.hpp"

#include <cmath>

#include "core/base/error.hpp"

namespace abstand::mechanism {

int Mechanism::indexOf(int id) const {
  for (std::size_t i = 0; i < frames.size(); ++i)
    if (frames[i].id == id) return static_cast<int>(i);
  return -1;
}

int Mechanism::indexOf(const std::string& frame_name) const {
  for (std::size_t i = 0; i < frames.size(); ++i)
    if (frames[i].name == frame_name) return static_cast<int>(i);
  return -1;
}

void Mechanism::prepare() {
  for (std::size_t i = 0; i < frames.size(); ++i) {
    auto& f = frames[i];
    ABSTAND_CHECK(f.parent >= -1 && f.parent < static_cast<int>(i));
    ABSTAND_CHECK(f.dof >= -1 && f.dof < dof && (f.dof < 0 || f.type != JointType::kFixed));
    ABSTAND_CHECK(std::abs(f.axis.norm() - 1.0) < 1e-9 && (!f.has_dh || f.axis == Vector3d::UnitZ()));
    if (!f.has_dh) continue;
    // RotZ(theta) and TransZ(d) commute, so either can be last as the variable.
    f.X_PJ = Eigen::AngleAxisd(f.alpha, Vector3d::UnitX()) * Eigen::Translation3d(f.a, 0.0, f.d) *
             Eigen::AngleAxisd(f.theta, Vector3d::UnitZ());
  }
  prepared = true;
}

}  // namespace abstand::mechanism
