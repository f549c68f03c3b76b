#include "core/control/admittance.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"

namespace abstand::control {

Admittance::Admittance(const AdmittanceOptions& options, int dof)
    : joints_(static_cast<std::size_t>(dof)), velocity_(joints_.size(), 0.0), offset_(joints_.size(), 0.0) {
  double Joint::*const members[] = {&Joint::inertia, &Joint::damping, &Joint::stiffness, &Joint::velocity,
                                    &Joint::offset};
  std::size_t next = 0;
  AdmittanceOptions::eachList(options, [&](const char* name, const config::JointNumbers& numbers,
                                           const config::NumberRule& rule) {
    const config::JointNumbers all = config::forJoints(AdmittanceOptions::kName, name, numbers, dof, rule);
    for (std::size_t i = 0; i < joints_.size(); ++i) joints_[i].*members[next] = all[i];
    ++next;
  });
}

void Admittance::hold() noexcept { std::fill(velocity_.begin(), velocity_.end(), 0.0); }

void Admittance::reset() noexcept {
  hold();
  std::fill(offset_.begin(), offset_.end(), 0.0);
}

void Admittance::update(std::span<const double> efforts, double dt,
                        std::span<const mechanism::VelocityBounds> bounds) noexcept {
  ABSTAND_CHECK(efforts.size() == joints_.size() && (bounds.empty() || bounds.size() == joints_.size()));
  if (!(dt > 0.0)) return;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const Joint& j = joints_[i];
    double &v = velocity_[i], &x = offset_[i];
    const double tau = std::isfinite(efforts[i]) ? efforts[i] : 0.0;
    v = (j.inertia * v + dt * (tau - j.stiffness * x)) / (j.inertia + dt * j.damping + dt * dt * j.stiffness);
    v = std::clamp(v, -j.velocity, j.velocity);
    if (!bounds.empty()) v = std::clamp(v, bounds[i].lower, bounds[i].upper);
    const double to = std::clamp(x + dt * v, -j.offset, j.offset);
    if (to != x + dt * v) v = (to - x) / dt;
    x = to;
  }
}

}  // namespace abstand::control
