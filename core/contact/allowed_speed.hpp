// Highest speed of approach whose contact stays within the limits.
#pragma once

#include <functional>

#include "core/contact/predicted_pressure.hpp"

namespace abstand::contact {

/// m/s, and the limit that determines it: kExcluded with speed 0 if contact is excluded or there is no region
/// to compare with.
struct AllowedSpeed {
  double speed{0.0};
  LimitKind kind{LimitKind::kExcluded};
  const RegionLimits* region{nullptr};
};

/// Contact patch of the robot's surface at an indentation (m).
using AreaAt = std::function<ContactArea(double indentation)>;

/// What a contact has in common at all speeds.
struct ContactPartner {
  RobotMass robot;
  ContactKind kind{ContactKind::kTransient};
};

/// The highest speed of approach, at most `wanted` (m/s), at which a contact stays within the limits of
/// force, energy and pressure of every region, as it is unknown which one is touched. Force and
/// energy have the closed form v = F_max / sqrt(mu k) (predicted_contact.hpp). Pressure depends on the shape
/// and is searched for: the result is a speed whose pressure was computed and is within its limit, or 0.
///
/// A contact passes through every smaller indentation before its largest one. So a speed whose pressure is
/// within its limit also allows all lower speeds, although the certified area of a curved surface vanishes
/// with the indentation. If the pressure at the force's limit is within its own limit, force alone decides.
/// Calls `area` once or twice for each region, and up to kPressureHalvings + kMoreThanHalvings times more
/// if pressure decides (mostly three). Pure if `area` is.
AllowedSpeed allowedSpeed(const std::vector<const RegionLimits*>& regions, const ContactPartner& partner,
                          double wanted, const AreaAt& area);

/// The search for a speed limited by pressure ends as narrow as after so many bisections: the result is below
/// the highest speed by at most `wanted` / 4096, if pressure rises with speed.
inline constexpr int kPressureHalvings = 12, kMoreThanHalvings = 3;

/// The largest share, 0 to 1, of the robot's speed with share * robot_speed + person_speed (m/s, towards each
/// other) <= `allowed`. 0 if the person's own speed exceeds that. robot_speed is positive.
double speedShare(double allowed, double robot_speed, double person_speed);

}  // namespace abstand::contact
