#include "core/control/torque_limit.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"

namespace abstand::control {

TorqueLimit::TorqueLimit(const TorqueLimitOptions& options, int dof)
    : gain_(options.gain), cut_(options.cut) {
  config::requireNumbers(options);
  TorqueLimitOptions::eachList(
      options, [&](const char* name, const config::JointNumbers& n, const config::NumberRule& rule) {
        max_torque_ = config::forJoints(TorqueLimitOptions::kName, name, n, dof, rule);
      });
}

int TorqueLimit::cut(std::span<double> torque) const noexcept {
  ABSTAND_CHECK(torque.size() == max_torque_.size());
  int farthest = -1;
  double smallest = 1.0, factor = 1.0;
  for (std::size_t i = 0; i < torque.size(); ++i) {
    double& tau = torque[i];
    const bool finite = std::isfinite(tau);
    if (!finite) tau = 0.0;
    if (finite && std::abs(tau) <= max_torque_[i]) continue;
    const double share = finite ? max_torque_[i] / std::abs(tau) : 0.0;
    if (farthest < 0 || share < smallest) {
      farthest = static_cast<int>(i);
      smallest = share;
    }
    if (finite) factor = std::min(factor, share);
    if (cut_ == TorqueCut::kEach && finite) tau = std::copysign(max_torque_[i], tau);
  }
  if (cut_ == TorqueCut::kTogether)
    for (std::size_t i = 0; i < torque.size(); ++i)
      torque[i] = std::clamp(torque[i] * factor, -max_torque_[i], max_torque_[i]);  // clamps rounding
  return farthest;
}

int TorqueLimit::update(std::span<const double> efforts, std::span<double> torque) const noexcept {
  ABSTAND_CHECK(efforts.size() == torque.size());
  for (std::size_t i = 0; i < torque.size(); ++i) torque[i] = gain_ * efforts[i];
  return cut(torque);
}

}  // namespace abstand::control
