// What a robot does about people and things near it, as plain values.
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

/// When a stop is asked for beside what the laws ask for. SI.
struct WatchOptions {
  static constexpr const char* kName = "stop";
  double distance{-kInfinity};  ///< m; nearer (certified lower bound), and something has to stop
  double input_age{0.1};        ///< s, of the newest joint values; older is stale
  double person_age{0.2};       ///< s, of the newest pose of a person; older is lost
  config::JointNumbers joint_speed{kInfinity};  ///< rad/s or m/s, of its size

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

/// A law that is there acts; they add up.
struct ReactionDescription {
  std::optional<TorqueLimitOptions> torque;  ///< contact efforts, with gain; limits the sum of all torques
  std::optional<RepulsionOptions> repulsion;
  std::optional<GodObjectOptions> proxy;        ///< for a held object
  std::optional<AdmittanceOptions> admittance;  ///< torques become velocities and offsets
  std::optional<SpeedScaleOptions> speed;
  std::optional<BrakingLawOptions> braking;  ///< looked after outside Reaction, which hears the cause
  HoldOptions hold;                          ///< where we move the robot ourselves
  WatchOptions watch;
  safety::StopOptions stop;
};

/// What would happen with weaker or stronger laws: the forces and the gain that push a robot away, times
/// `factor`; limits, damping ratios, speeds and stops stay.
void scaleGains(ReactionDescription& reaction, double factor);

}  // namespace abstand::control
