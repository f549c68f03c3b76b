// Parameters of a robot's reaction to people and things, as plain values.
#pragma once

#include <optional>

#include "core/control/admittance.hpp"
#include "core/control/braking_law.hpp"
#include "core/control/god_object.hpp"
#include "core/control/hold.hpp"
#include "core/control/repulsion.hpp"
#include "core/control/speed_scale.hpp"
#include "core/control/torque_limit.hpp"
#include "core/safety/stop_machine.hpp"

namespace abstand::control {

/// Conditions that require a stop in addition to the laws. SI.
struct WatchOptions {
  static constexpr const char* kName = "stop";
  double distance{-kInfinity};                  ///< m; a smaller certified distance requires a stop
  double input_age{0.1};                        ///< s, age of the newest joint values; older ones are stale
  double person_age{0.2};                       ///< s, age of the newest pose of a person; older: lost
  config::JointNumbers joint_speed{kInfinity};  ///< rad/s or m/s, absolute value

  template <class Self, class Visit>
  static void eachNumber(Self& o, Visit visit) {
    visit("distance", o.distance, config::NumberRule{-kInfinity, 100.0, "m"});
    visit("input_age", o.input_age, config::NumberRule{0.0, kInfinity, "s", true});
    visit("person_age", o.person_age, config::NumberRule{0.0, kInfinity, "s", true});
  }
  template <class Self, class Visit>
  static void eachList(Self& o, Visit visit) {
    visit("joint_speed", o.joint_speed, config::NumberRule{0.0, kInfinity, "rad/s or m/s", true});
  }
};

/// A law that is present is active; their effects add up.
struct ReactionDescription {
  std::optional<TorqueLimitOptions> torque;  ///< contact efforts times a gain; limits the sum of all torques
  std::optional<RepulsionOptions> repulsion;
  std::optional<GodObjectOptions> proxy;        ///< for a held object
  std::optional<AdmittanceOptions> admittance;  ///< turns torques into velocities and offsets
  std::optional<SpeedScaleOptions> speed;
  std::optional<BrakingLawOptions> braking;  ///< evaluated outside of Reaction, which receives the cause
  HoldOptions hold;                          ///< used if this program moves the robot
  WatchOptions watch;
  safety::StopOptions stop;
};

/// Scales the strength of the laws, i.e. the forces and the gain that push a robot away, by `factor`; limits,
/// damping ratios, speeds and stops are unchanged.
void scaleGains(ReactionDescription& reaction, double factor);

}  // namespace abstand::control
