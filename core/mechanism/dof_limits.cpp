#include "core/mechanism/dof_limits.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::mechanism {
namespace {

/// The frame whose joint leads each dof; null if none does.
std::vector<const MechanismFrame*> leaders(const Mechanism& mechanism) {
  std::vector<const MechanismFrame*> found(static_cast<std::size_t>(mechanism.dof), nullptr);
  for (const auto& f : mechanism.frames) {
    if (f.dof < 0) continue;
    const MechanismFrame*& leader = found[static_cast<std::size_t>(f.dof)];
    if (!leader || (leader->mimic && !f.mimic)) leader = &f;
  }
  return found;
}

double largestTowards(double distance, double braking, double h) {
  if (!(distance > 0.0)) return 0.0;
  if (distance == kInfinity) return kInfinity;
  return 2.0 * distance / (h + std::sqrt(h * h + 2.0 * distance / braking));
}

}  // namespace

std::vector<DofLimits> dofLimits(const Mechanism& mechanism) {
  std::vector<DofLimits> limits(static_cast<std::size_t>(mechanism.dof));
  const auto frames = leaders(mechanism);
  for (std::size_t k = 0; k < limits.size(); ++k) {
    if (!frames[k] || frames[k]->scale == 0.0) continue;
    const MechanismFrame& f = *frames[k];
    const double scale = std::abs(f.scale);
    const auto [a, b] =
        std::minmax({(f.limits.lower - f.offset) / f.scale, (f.limits.upper - f.offset) / f.scale});
    limits[k] = {a, b, f.limits.velocity / scale, f.limits.acceleration / scale, f.limits.effort * scale};
  }
  return limits;
}

std::vector<std::string> dofNames(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (const MechanismFrame* f : leaders(mechanism))
    names.push_back(!f ? std::to_string(names.size()) : f->joint.empty() ? f->name : f->joint);
  return names;
}

VelocityBounds velocityBounds(const DofLimits& l, double q, double qd, double braking, double h) noexcept {
  VelocityBounds bounds;
  bounds.upper = std::min(l.velocity, largestTowards(l.upper - q, braking, h));
  bounds.lower = std::max(-l.velocity, -largestTowards(q - l.lower, braking, h));
  if (l.acceleration < kInfinity) {
    const double change = h * l.acceleration;
    bounds.upper = std::clamp(bounds.upper, qd - change, qd + change);
    bounds.lower = std::clamp(bounds.lower, qd - change, qd + change);
  }
  return bounds;
}

}  // namespace abstand::mechanism
