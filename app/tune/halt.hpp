// How a robot comes to rest on its own path.
#pragma once

#include <algorithm>

#include "core/math/transform.hpp"

namespace abstand::tune {

struct BrakingOptions {
  /// s, from the frame that breaks a margin until the robot begins to slow down: sensor, network, controller.
  double reaction_time{0.1};
  /// rad/s^2 or m/s^2, of each joint: none slows down faster (robot's data sheet).
  double deceleration{5.0};
};

/// A robot that is told to stop at t = 0 goes on for the reaction time and then along its path with a pace
/// that falls evenly from 1 to 0. The times of the program that it passes lag behind the clock.
struct Halt {
  double reaction{0.0}, braking{0.0};  ///< s
  double duration() const { return reaction + braking; }
  /// s of the program, t s (0 or more) after the stop was told.
  double programTime(double t) const {
    if (t <= reaction || braking <= 0.0) return std::min(t, reaction);
    const double s = std::min(t - reaction, braking);
    return reaction + s - 0.5 * s * s / braking;
  }
  /// Seconds of the program per second.
  double pace(double t) const {
    if (t <= reaction) return 1.0;
    return braking > 0.0 ? std::max(0.0, 1.0 - (t - reaction) / braking) : 0.0;
  }
};

}  // namespace abstand::tune
