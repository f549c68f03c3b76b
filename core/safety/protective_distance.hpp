// Speed and separation monitoring: protective distance for a speed of the robot.
#pragma once

#include "core/safety/reach_set.hpp"

namespace abstand::safety {

/// Editions that the formula and the default speeds of people come from. ISO 10218-2:2025 has taken over the
/// requirements of ISO/TS 15066:2016, and ISO 13855 has an edition of 2024: whoever owns those compares the
/// values with them (docs/margins.md).
inline constexpr const char* kSeparationEdition = "ISO/TS 15066:2016, 5.5.4";
inline constexpr const char* kApproachSpeedEdition = "ISO 13855:2010";

/// Terms of S_p [kSeparationEdition], with the speeds of people of kApproachSpeedEdition as defaults. SI.
struct SeparationOptions {
  static constexpr const char* kName = "separation";
  double reaction_time{0.1};  ///< s, T_r: sensor, network and controller together
  double stopping_time{0.3};  ///< s, T_s, from the robot's manufacturer; used if `deceleration` is 0
  /// m/s^2 along the direction of approach; if not 0, T_s = v_r / deceleration.
  double deceleration{0.0};
  double intrusion{0.0};     ///< m, C: how far a person intrudes before the sensor detects it
  double person_error{0.0};  ///< m, Z_d: error of the person's measured position
  double robot_error{0.0};   ///< m, Z_r: error of the robot's position
  /// m/s, v_h of a person whose speed is not measured: 1.6 for walking, and 2.0, that of a hand, if nearer
  /// than `near` [ISO 13855:2010]. Also the limit that a measured speed is assumed to grow to.
  double person_speed{1.6}, person_speed_near{2.0};
  double near{0.5};  ///< m
  /// m/s^2. A person with the measured approach speed v moves at most v T + a T^2 / 2 within T, and never
  /// more than without a measurement. 0: measured speeds are not used.
  double person_acceleration{0.0};

  template <class Self, class Visit>
  static void eachNumber(Self& o, Visit visit) {
    visit("reaction_time", o.reaction_time, config::NumberRule{0.0, 10.0, "s"});
    visit("stopping_time", o.stopping_time, config::NumberRule{0.0, 10.0, "s"});
    visit("deceleration", o.deceleration, config::NumberRule{0.0, 1e3, "m/s^2"});
    visit("intrusion", o.intrusion, config::NumberRule{0.0, 10.0, "m"});
    visit("person_error", o.person_error, config::NumberRule{0.0, 10.0, "m"});
    visit("robot_error", o.robot_error, config::NumberRule{0.0, 10.0, "m"});
    visit("person_speed", o.person_speed, config::NumberRule{0.0, 20.0, "m/s"});
    visit("person_speed_near", o.person_speed_near, config::NumberRule{0.0, 20.0, "m/s"});
    visit("near", o.near, config::NumberRule{0.0, 10.0, "m"});
    visit("person_acceleration", o.person_acceleration, config::NumberRule{0.0, 1e3, "m/s^2"});
  }
  void validate() const { config::requireNumbers(*this); }  ///< throws UsageError
};

/// Terms of S_p = S_h + S_r + S_s + C + Z_d + Z_r (m), separate to show which one causes a stop.
struct ProtectiveDistance {
  double person{0.0};    ///< S_h = v_h (T_r + T_s), or less by a measured speed
  double reaction{0.0};  ///< S_r = v_r T_r
  double stopping{0.0};  ///< S_s = v_r T_s / 2 at constant deceleration
  double constant{0.0};  ///< C + Z_d + Z_r
  double sum() const { return person + reaction + stopping + constant; }
};

/// m/s: with the defaults 2.0 if nearer than `near`, otherwise 1.6.
double assumedPersonSpeed(const SeparationOptions& options, double distance) noexcept;

/// @param robot_speed   v_r, m/s, of the robot towards the person; negative values count as 0
/// @param person_speed  m/s, measured approach speed of the person (negative: moving away), or NaN: unknown
/// @param distance      m, compared with `near`
ProtectiveDistance protectiveDistance(const SeparationOptions& options, double robot_speed,
                                      double person_speed, double distance) noexcept;

/// The highest v_r in [0, `wanted`] (m/s) whose protective distance is at most `distance`; 0 if there is
/// none. With constant T_s: (d - S_h - C - Z_d - Z_r) / (T_r + T_s / 2).
double permittedSpeed(const SeparationOptions& options, double wanted, double person_speed,
                      double distance) noexcept;

}  // namespace abstand::safety
