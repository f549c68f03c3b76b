#include "core/safety/link_motion.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"

namespace abstand::safety {
namespace {

constexpr double kSpeedUp = 1.0 + 1e-12;  // for rounding

}  // namespace

LinkMotion::LinkMotion(const mechanism::Mechanism& mechanism, const BrakingPath& path, int frame,
                       const Transform& X_WB, const Transform& X_FL,
                       const geometry::EnclosingSphere& sphere_L)
    : mechanism_(mechanism),
      path_(path),
      frame_(frame),
      X_WB_(X_WB),
      X_FL_(X_FL),
      reach_((X_FL * sphere_L.centre).norm() + sphere_L.radius),
      q_(static_cast<std::size_t>(mechanism.dof), 0.0) {
  ABSTAND_CHECK(path.dof() == mechanism.dof && frame < static_cast<int>(mechanism.frames.size()));
  mechanism::forward(mechanism_, q_, state_);  // allocates the state
}

Transform LinkMotion::pose(double t) noexcept {
  if (frame_ < 0) return X_WB_ * X_FL_;
  path_.at(t, q_);
  mechanism::forward(mechanism_, q_, state_);
  return X_WB_ * state_.X_BF[static_cast<std::size_t>(frame_)] * X_FL_;
}

double LinkMotion::speed(double t0, double t1) const noexcept {
  double lever = reach_, speed = 0.0;
  for (int i = frame_; i >= 0;) {
    const mechanism::MechanismFrame& f = mechanism_.frames[static_cast<std::size_t>(i)];
    const bool moves = f.type != mechanism::JointType::kFixed && f.dof >= 0;
    const double rate = moves ? std::abs(f.scale) * path_.fastest(f.dof, t0) : 0.0;
    speed += f.type == mechanism::JointType::kPrismatic ? rate : rate * lever;
    lever += f.X_PJ.translation().norm();
    if (f.type == mechanism::JointType::kPrismatic) {
      // A joint moves in one direction only, so the larger extension is at an end.
      const auto extension = [&](double t) {
        return std::abs(f.offset + (f.dof < 0 ? 0.0 : f.scale * path_.q(f.dof, t)));
      };
      lever += std::max(extension(t0), extension(t1));
    }
    i = f.parent;
  }
  return speed * kSpeedUp;
}

}  // namespace abstand::safety
