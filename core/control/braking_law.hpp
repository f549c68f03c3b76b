// Braking law: a robot may only move as long as it can brake before a person can reach its path.
#pragma once

#include "core/safety/braking_path.hpp"
#include "core/safety/reach_set.hpp"

namespace abstand::control {

/// Braking of the robot, and the assumed motion of people meanwhile. SI.
struct BrakingLawOptions {
  static constexpr const char* kName = "braking";
  safety::BrakingOptions path;
  double distance{0.0};  ///< m, required distance at every time until standstill
  /// m/s; a person seen moving faster is assumed to continue at most at this speed [ISO 13855:2010: 2 m/s for
  /// a hand]
  double person_speed{2.0};
  double person_acceleration{kInfinity};  ///< m/s^2; infinite: bounded by the speed only

  template <class Self, class Visit>
  static void eachNumber(Self& o, Visit visit) {
    safety::BrakingOptions::eachNumber(o.path, visit);
    visit("distance", o.distance, config::NumberRule{-10.0, 10.0, "m"});
    visit("person_speed", o.person_speed, config::NumberRule{0.0, 100.0, "m/s"});
    visit("person_acceleration", o.person_acceleration, config::NumberRule{0.0, kInfinity, "m/s^2"});
  }
  template <class Self, class Visit>
  static void eachList(Self& o, Visit visit) {
    visit("deceleration", o.path.deceleration, safety::BrakingOptions::kDecelerationRule);
  }
};

}  // namespace abstand::control
