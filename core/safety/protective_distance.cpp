#include "core/safety/protective_distance.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::safety {
namespace {

// Bisections of the wanted speed: accuracy of one part in 10^9.
constexpr int kHalvings = 30;

double stoppingTime(const SeparationOptions& o, double robot_speed) {
  return o.deceleration > 0.0 ? robot_speed / o.deceleration : o.stopping_time;
}

}  // namespace

double assumedPersonSpeed(const SeparationOptions& o, double distance) noexcept {
  // An unknown distance counts as near.
  return distance >= o.near ? o.person_speed : std::max(o.person_speed, o.person_speed_near);
}

ProtectiveDistance protectiveDistance(const SeparationOptions& o, double robot_speed, double person_speed,
                                      double distance) noexcept {
  const double v_r = std::max(0.0, robot_speed), v_h = assumedPersonSpeed(o, distance);
  const double stopping = stoppingTime(o, v_r), time = o.reaction_time + stopping;
  ProtectiveDistance s;
  s.person = v_h * time;
  if (o.person_acceleration > 0.0 && !std::isnan(person_speed))
    s.person = std::min(s.person, travelWithin(person_speed, {v_h, o.person_acceleration}, time));
  s.reaction = v_r * o.reaction_time;
  s.stopping = 0.5 * v_r * stopping;
  s.constant = o.intrusion + o.person_error + o.robot_error;
  return s;
}

double permittedSpeed(const SeparationOptions& o, double wanted, double person_speed,
                      double distance) noexcept {
  if (!(wanted > 0.0)) return 0.0;
  const auto fits = [&](double v) {
    return protectiveDistance(o, v, person_speed, distance).sum() <= distance;
  };
  if (fits(wanted)) return wanted;
  if (!fits(0.0)) return 0.0;
  const ProtectiveDistance still = protectiveDistance(o, 0.0, person_speed, distance);
  const double spread = o.reaction_time + 0.5 * o.stopping_time;
  if (o.deceleration == 0.0 && spread > 0.0) return std::min(wanted, (distance - still.sum()) / spread);
  double lower = 0.0, upper = wanted;
  for (int i = 0; i < kHalvings; ++i) {
    const double v = 0.5 * (lower + upper);
    (fits(v) ? lower : upper) = v;
  }
  return lower;
}

}  // namespace abstand::safety
