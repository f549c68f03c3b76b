// The share of its planned speed that a robot may go, by who is near and which way it goes.
#pragma once

#include <span>

#include "core/safety/protective_distance.hpp"

namespace abstand::control {

struct SpeedScaleOptions {
  static constexpr const char* kName = "speed";
  safety::SeparationOptions separation;
  /// 1/s. Down at once, up at this rate, so that a person at the edge does not make the robot stutter.
  double release{2.0};
  double least{0.02};  ///< shares below count as 0

  template <class Self, class Visit>
  static void eachNumber(Self& o, Visit visit) {
    safety::SeparationOptions::eachNumber(o.separation, visit);
    visit("release", o.release, config::NumberRule{0.0, 1e6, "1/s", true});
    visit("least", o.least, config::NumberRule{0.0, 1.0});
  }
  void validate() const { config::requireNumbers(*this); }  ///< throws UsageError
};

/// One pair of a robot's link and a person's part.
struct Approach {
  double distance{kInfinity};  ///< m, lower bound of the true distance
  /// m/s, how fast the link would come nearer at its planned speed; negative: it goes away
  double robot{0.0};
  double person{kNaN};  ///< m/s, how fast the person's part comes nearer; NaN: not known
};

/// Speed and separation monitoring (protective_distance.hpp) that looks at the direction: the speed that
/// counts is that along the line between the nearest points, and a pair whose link goes away does not slow
/// the robot, however near it is. A pair that comes nearer at v allows the share permittedSpeed(v) / v; the
/// smallest share of all pairs is the scale. Where the bodies are convex about the nearest points, the gap
/// between them shrinks no faster than that. One thread, no allocation.
class SpeedScale {
 public:
  explicit SpeedScale(const SpeedScaleOptions& options);  ///< throws UsageError

  /// From a standing robot, which then speeds up at the rate of release.
  void stop() noexcept { scale_ = 0.0; }
  /// The scale, 0 to 1, for this cycle. dt (s) since the last one. A pair with a NaN among distance and robot
  /// stops the robot.
  double update(std::span<const Approach> pairs, double dt) noexcept;
  double scale() const { return scale_; }
  int slowest() const { return slowest_; }  ///< the pair that allows least, -1 when none slows
  /// m/s: what that pair allows, and what was planned there.
  double permitted() const { return permitted_; }
  double planned() const { return planned_; }
  const SpeedScaleOptions& options() const { return o_; }

 private:
  SpeedScaleOptions o_;
  double scale_{1.0}, permitted_{0.0}, planned_{0.0};
  int slowest_{-1};
};

}  // namespace abstand::control
