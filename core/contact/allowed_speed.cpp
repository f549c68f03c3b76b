#include "core/contact/allowed_speed.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::contact {
namespace {

/// Allowed speed for one region, at most `wanted`.
AllowedSpeed speedOf(const RegionLimits& region, const RobotMass& robot, double wanted, const AreaAt& area) {
  if (region.excluded()) return {0.0, LimitKind::kExcluded, &region};
  const double by_force = predictContact(region, {0.0, robot}).allowed_speed;
  if (!(by_force > 0.0)) return {0.0, LimitKind::kForce, &region};
  const auto pressed = [&](double speed) {
    const PredictedContact contact = predictContact(region, {speed, robot});
    return predictPressure(region, contact, area(contact.indentation), ContactKind::kTransient).share <= 1.0;
  };
  const AllowedSpeed force{std::min(by_force, wanted), LimitKind::kForce, &region};
  // A small indentation has the smaller patch; that of a large one may be certain where the small one's is
  // not.
  if (pressed(force.speed) || (wanted < by_force && pressed(by_force))) return force;
  double kept = 0.0, broken = force.speed;
  for (int i = 0; i < kPressureHalvings; ++i) {
    const double speed = 0.5 * (kept + broken);
    (pressed(speed) ? kept : broken) = speed;
  }
  return {kept, LimitKind::kPressure, &region};
}

}  // namespace

AllowedSpeed allowedSpeed(const std::vector<const RegionLimits*>& regions, const RobotMass& robot,
                          double wanted, const AreaAt& area) {
  AllowedSpeed least;
  for (const RegionLimits* region : regions)
    if (region->excluded()) return {0.0, LimitKind::kExcluded, region};
  if (!(wanted > 0.0)) return least;
  for (const RegionLimits* region : regions) {
    const AllowedSpeed allowed = speedOf(*region, robot, least.region ? least.speed : wanted, area);
    if (!least.region || allowed.speed < least.speed) least = allowed;
    if (!(least.speed > 0.0)) break;
  }
  return least;
}

double speedShare(double allowed, double robot_speed, double person_speed) {
  if (std::isnan(allowed) || std::isnan(person_speed) || !(robot_speed > 0.0)) return 0.0;
  // Rounding must not reduce a speed that is allowed unchanged.
  if (robot_speed + person_speed <= allowed) return 1.0;
  return std::clamp((allowed - person_speed) / robot_speed, 0.0, 1.0);
}

}  // namespace abstand::contact
