// Plan of a robot in the closed loop, on a clock of its own.
#pragma once

#include <optional>
#include <vector>

#include "core/control/hold.hpp"
#include "core/mechanism/smooth_motion.hpp"

namespace abstand::loop {

/// Smoothed motion of a mechanism, or rest at its joint values. Its clock runs at the speed scale, so a robot
/// that was slowed down or stopped continues where it was. One thread; no allocation after construction.
class MotionClock {
 public:
  /// `motion`: null for rest at `q`.
  MotionClock(const mechanism::MotionTable* motion, std::span<const double> q, double start);

  /// Advances by `dt` seconds at the share `scale` (0 to 1) of the planned speed.
  void advance(double dt, double scale);
  /// Planned motion now: qd and qdd include the current speed scale.
  control::PlannedMotion now() const { return {q_, qd_, qdd_}; }
  /// Planned velocity (rad/s or m/s) at full speed.
  std::span<const double> fullSpeed() const { return full_; }
  double time() const { return time_; }  ///< s, on its own clock

 private:
  void evaluate(double scale);

  std::optional<mechanism::SmoothMotion> motion_;
  std::vector<double> q_, qd_, qdd_, full_;
  double time_;
};

}  // namespace abstand::loop
