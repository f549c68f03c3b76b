// Peak force, energy and indentation of a contact, and what the table allows.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/contact/contact_limits.hpp"

namespace abstand::contact {

/// kTransient: the body part can recoil. kQuasiStatic: it is clamped between the robot and something fixed
/// [ISO/TS 15066:2016, clause 3].
enum class ContactKind : std::uint8_t { kTransient, kQuasiStatic };

/// Where a robot's effective mass comes from: the inertia seen along the contact normal in this posture
/// (mechanism::effectiveMass; Khatib 1995), or the estimate of ISO/TS 15066:2016.
enum class RobotMassSource : std::uint8_t { kPosture, kHalfMovingMass };

/// "effective mass of the posture" or "m_R = M/2 + m_L (ISO/TS 15066:2016)".
std::string_view sourceText(RobotMassSource source);

struct RobotMass {
  double kg{0.0};  ///< infinite: a wall. What is not positive or NaN counts as infinite.
  RobotMassSource source{RobotMassSource::kPosture};
};

/// m_R = M / 2 + m_L, kg [ISO/TS 15066:2016, annex A].
/// @param moving_mass  M, kg, of all moving parts of the robot
/// @param load         m_L, kg, effective payload with tool and workpiece
RobotMass estimatedRobotMass(double moving_mass, double load);

/// A moment of a motion at which robot and body part touch, or are taken to touch.
struct ContactMotion {
  /// m/s, of approach along the contact normal, positive towards each other. What is not positive makes no
  /// impact; NaN is an unknown speed and exceeds every limit.
  double speed{0.0};
  RobotMass robot;
  ContactKind kind{ContactKind::kTransient};
};

/// Two masses and a linear spring, without damping [ISO/TS 15066:2016, annex A]. SI.
struct PredictedContact {
  /// kg. mu = (1 / m_H + 1 / m_R)^-1. A clamped part cannot recoil, so that mu = m_R there; this is our own
  /// choice, on the safe side.
  double reduced_mass{0.0};
  double energy{0.0};       ///< J, E = mu v^2 / 2
  double force{0.0};        ///< N, peak, F = v sqrt(mu k)
  double indentation{0.0};  ///< m, at the peak, x = F / k
  /// N, F_max: the quasi-static force, times the factor where contact is transient. 0: excluded.
  double allowed_force{0.0};
  double allowed_energy{0.0};  ///< J, F_max^2 / (2 k)
  double allowed_speed{0.0};   ///< m/s, v_max = F_max / sqrt(mu k)
  /// F / F_max, which is v / v_max too, and the root of E / E_max. 1: at the limit. Infinite where contact is
  /// excluded, whatever the speed, and where speed is unknown.
  double share{0.0};
  bool excluded{false};
};

/// The force with which the robot's motors go on pressing a clamped part is not in it. Pure; any thread.
PredictedContact predictContact(const RegionLimits& region, const ContactMotion& motion);

/// The region among those of a body part that has used most of its limit; where shares tie, the one that
/// allows the least speed. It is not known which of them is touched, so the worst one counts. Null for no
/// regions.
struct RegionContact {
  const RegionLimits* region{nullptr};
  PredictedContact contact;
};
RegionContact worstContact(const std::vector<const RegionLimits*>& regions, const ContactMotion& motion);

}  // namespace abstand::contact
