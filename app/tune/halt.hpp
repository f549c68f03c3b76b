// Braking of a robot on its own path.
#pragma once

#include <algorithm>

#include "core/math/transform.hpp"

namespace abstand::tune {

struct BrakingOptions {
  /// s, from the frame that violates a margin until the robot begins to brake: sensor, network, controller.
  double reaction_time{0.1};
  /// rad/s^2 or m/s^2, smallest deceleration of all joints (robot's data sheet).
  double deceleration{5.0};
};

/// A robot commanded to stop at t = 0 continues for the reaction time and then along its path with a pace
/// that decreases linearly from 1 to 0. Its program time lags behind the clock.
struct Halt {
  double reaction{0.0}, braking{0.0};  ///< s
  double duration() const { return reaction + braking; }
  /// Program time (s) at t s (>= 0) after the stop command.
  double programTime(double t) const {
    if (t <= reaction || braking <= 0.0) return std::min(t, reaction);
    const double s = std::min(t - reaction, braking);
    return reaction + s - 0.5 * s * s / braking;
  }
  /// Program seconds for each second of the clock.
  double pace(double t) const {
    if (t <= reaction) return 1.0;
    return braking > 0.0 ? std::max(0.0, 1.0 - (t - reaction) / braking) : 0.0;
  }
};

}  // namespace abstand::tune
