// Predicted force, energy and indentation of a contact, and the allowed values.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/contact/contact_limits.hpp"

namespace abstand::contact {

/// kTransient: the body part can recoil. kQuasiStatic: it is clamped between the robot and something fixed
/// [ISO/TS 15066:2016, clause 3].
enum class ContactKind : std::uint8_t { kTransient, kQuasiStatic };

/// "transient" or "quasi-static".
std::string_view kindText(ContactKind kind);

/// Source of a robot's effective mass: inertia along the contact normal in this posture
/// (mechanism::effectiveMass; Khatib 1995), or the estimate of ISO/TS 15066:2016.
enum class RobotMassSource : std::uint8_t { kPosture, kHalfMovingMass };

/// "effective mass of the posture" or "m_R = M/2 + m_L (ISO/TS 15066:2016)".
std::string_view sourceText(RobotMassSource source);

struct RobotMass {
  double kg{0.0};  ///< infinite: immovable. NaN and values that are not positive count as infinite.
  RobotMassSource source{RobotMassSource::kPosture};
};

/// m_R = M / 2 + m_L, kg [ISO/TS 15066:2016, annex A].
/// @param moving_mass  M, kg, of all moving parts of the robot
/// @param load         m_L, kg, effective payload with tool and workpiece
RobotMass estimatedRobotMass(double moving_mass, double load);

/// State of motion at contact, real or assumed.
struct ContactMotion {
  /// m/s, approach speed along the contact normal, positive towards each other. Values <= 0 cause no impact;
  /// NaN is an unknown speed and exceeds every limit.
  double speed{0.0};
  RobotMass robot;
  ContactKind kind{ContactKind::kTransient};
};

/// Model: two masses and a linear undamped spring [ISO/TS 15066:2016, annex A]. SI.
struct PredictedContact {
  /// kg. mu = (1 / m_H + 1 / m_R)^-1. A clamped part cannot recoil, so mu = m_R there (own choice, on the
  /// safe side).
  double reduced_mass{0.0};
  double energy{0.0};       ///< J, E = mu v^2 / 2
  double force{0.0};        ///< N, peak, F = v sqrt(mu k)
  double indentation{0.0};  ///< m, at the peak, x = F / k
  /// N, F_max: the quasi-static force, times the factor for transient contact. 0: excluded.
  double allowed_force{0.0};
  double allowed_energy{0.0};  ///< J, F_max^2 / (2 k)
  double allowed_speed{0.0};   ///< m/s, v_max = F_max / sqrt(mu k)
  /// F / F_max = v / v_max = sqrt(E / E_max). 1: at the limit. Infinite if contact is excluded, at any speed,
  /// and if the speed is unknown.
  double share{0.0};
  bool excluded{false};
};

/// Without the force by which the motors keep pressing on a clamped part. Pure; any thread.
PredictedContact predictContact(const RegionLimits& region, const ContactMotion& motion);

/// The region of a body part with the largest share of its limit; of equal ones, that with the lowest allowed
/// speed. It is unknown which one is touched, so the worst counts. Null if there are no regions.
struct RegionContact {
  const RegionLimits* region{nullptr};
  PredictedContact contact;
};
RegionContact worstContact(const std::vector<const RegionLimits*>& regions, const ContactMotion& motion);

}  // namespace abstand::contact
