// The highest speed of approach whose contact stays within the limits.
#pragma once

#include <functional>

#include "core/contact/predicted_pressure.hpp"

namespace abstand::contact {

/// m/s, and the limit that decides it: kExcluded with a speed of 0 where contact is excluded, or where there
/// is no region to compare with.
struct AllowedSpeed {
  double speed{0.0};
  LimitKind kind{LimitKind::kExcluded};
  const RegionLimits* region{nullptr};
};

/// Patch of the robot's surface at an indentation (m).
using AreaAt = std::function<ContactArea(double indentation)>;

/// The highest speed of approach, `wanted` (m/s) at most, at which a transient contact stays within the
/// limits of force, energy and pressure of every region: it is not known which of them is touched. Force and
/// energy have the closed form v = F_max / sqrt(mu k) (predicted_contact.hpp), the pressure depends on the
/// shape and is bisected: the answer is a speed at which it was computed and found within its limit, or 0.
///
/// A contact passes through every smaller indentation before its largest one. So a speed whose pressure is
/// within its limit allows all slower ones, too, although the certified area of a curved surface vanishes
/// with the indentation: where the pressure at the force's own limit is within its limit, force alone
/// decides. Calls `area` once for each region, and kPressureHalvings times more where pressure decides. Pure
/// if `area` is.
AllowedSpeed allowedSpeed(const std::vector<const RegionLimits*>& regions, const RobotMass& robot,
                          double wanted, const AreaAt& area);

/// Halvings of a speed that the pressure limits: the answer is less than the highest speed by one part in
/// 4096 of `wanted` at most, where pressure rises with speed.
inline constexpr int kPressureHalvings = 12;

/// The largest share, 0 to 1, of the robot's speed at which share * robot_speed + person_speed (m/s, towards
/// each other) is `allowed` at most. 0 where the person's own speed is above that. robot_speed is positive.
double speedShare(double allowed, double robot_speed, double person_speed);

}  // namespace abstand::contact
