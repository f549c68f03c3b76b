// What a robot may do next: only what it can brake from before anybody can be where it goes.
#pragma once

#include "core/safety/braking_path.hpp"
#include "core/safety/reach_set.hpp"

namespace abstand::control {

/// How the robot brakes, and what is taken for granted of people meanwhile. SI.
struct BrakingLawOptions {
  static constexpr const char* kName = "braking";
  safety::BrakingOptions path;
  double distance{0.0};  ///< m, that has to be left at every moment until it stands
  /// m/s; who was seen faster is taken to go on at most that fast [ISO 13855: 2 m/s for a hand].
  double person_speed{2.0};
  double person_acceleration{kInfinity};  ///< m/s^2; infinite: only the speed bounds them

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
