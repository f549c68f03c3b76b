// Speed scale of a robot by speed and separation monitoring with direction.
#pragma once

#include <span>

#include "core/safety/protective_distance.hpp"

namespace abstand::control {

struct SpeedScaleOptions {
  static constexpr const char* kName = "speed";
  safety::SeparationOptions separation;
  /// 1/s. The scale falls at once and rises at this rate, so that a person at the edge does not cause
  /// stuttering.
  double release{2.0};
  double min_scale{0.02};  ///< smaller scales count as 0

  template <class Self, class Visit>
  static void eachNumber(Self& o, Visit visit) {
    safety::SeparationOptions::eachNumber(o.separation, visit);
    visit("release", o.release, config::NumberRule{0.0, 1e6, "1/s", true});
    visit("least", o.min_scale, config::NumberRule{0.0, 1.0});
  }
  void validate() const { config::requireNumbers(*this); }  ///< throws UsageError
};

/// One pair of a robot's link and a person's part.
struct Approach {
  double distance{kInfinity};  ///< m, lower bound of the true distance
  /// m/s, approach speed of the link at its planned speed; negative: it recedes
  double robot{0.0};
  double person{kNaN};  ///< m/s, approach speed of the person's part; NaN: unknown
};

/// Speed and separation monitoring (protective_distance.hpp) with the direction of motion: the speed is that
/// along the line of the nearest points, and a pair whose link recedes does not slow the robot at any
/// distance. A pair with approach speed v allows the share permittedSpeed(v) / v; the smallest share of all
/// pairs is the scale. If the bodies are convex near the nearest points, their distance decreases no faster.
/// One thread, no allocation.
class SpeedScale {
 public:
  explicit SpeedScale(const SpeedScaleOptions& options);  ///< throws UsageError

  /// Replaces the options; the scale stays. `options`: validated.
  void setOptions(const SpeedScaleOptions& options) noexcept { o_ = options; }
  /// Sets the scale to 0; it then rises at the rate `release`.
  void stop() noexcept { scale_ = 0.0; }
  /// The scale, 0 to 1, for this cycle; dt (s) since the last one. A pair with NaN as distance or robot speed
  /// stops the robot.
  double update(std::span<const Approach> pairs, double dt) noexcept;
  double scale() const { return scale_; }
  int slowest() const { return slowest_; }  ///< the pair with the smallest share, -1 if none slows
  /// m/s: permitted and planned speed of that pair
  double permitted() const { return permitted_; }
  double planned() const { return planned_; }
  const SpeedScaleOptions& options() const { return o_; }

 private:
  SpeedScaleOptions o_;
  double scale_{1.0}, permitted_{0.0}, planned_{0.0};
  int slowest_{-1};
};

}  // namespace abstand::control
