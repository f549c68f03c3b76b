// Braking of a mechanism: joint values over time, and braking distances.
#pragma once

#include <span>
#include <vector>

#include "core/config/number_rule.hpp"

namespace abstand::safety {

/// kEachJoint: each joint brakes with its own deceleration. kTogether: all joints stop at the same time, that
/// of the slowest, so that the mechanism stays on a line in joint space, which is its path to first order.
enum class BrakingKind { kEachJoint, kTogether };

struct BrakingOptions {
  static constexpr const char* kName = "braking";
  static constexpr config::NumberRule kDecelerationRule{0.0, 1e6, "rad/s^2 or m/s^2", true};
  config::JointNumbers deceleration{5.0};  ///< rad/s^2 or m/s^2, one for each joint or one for all
  double reaction_time{0.01};              ///< s, in which the joints keep their velocities before they brake
  BrakingKind kind{BrakingKind::kEachJoint};

  template <class Self, class Visit>
  static void eachNumber(Self& o, Visit visit) {
    visit("reaction_time", o.reaction_time, config::NumberRule{0.0, 10.0, "s"});
  }
};

/// Braking with constant decelerations after a reaction time. Sizes are fixed at construction; start() and
/// everything below do not allocate. SI.
class BrakingPath {
 public:
  /// Throws UsageError for options that are not valid for `dof` joints.
  BrakingPath(const BrakingOptions& options, int dof);

  /// Starts at these joint values and velocities, both of size dof. Returns false, with the path at rest at
  /// q, if a value is not finite: then nothing is certified.
  bool start(std::span<const double> q, std::span<const double> qd) noexcept;

  int dof() const { return static_cast<int>(q_.size()); }
  double q(int joint, double t) const noexcept;
  double qd(int joint, double t) const noexcept;
  void at(double t, std::span<double> q) const noexcept;
  /// Highest absolute velocity from t0 on.
  double fastest(int joint, double t0) const noexcept;
  double stopTime(int joint) const noexcept;  ///< s from now, including the reaction time
  double stopTime() const noexcept { return stop_time_; }
  double brakingDistance(int joint) const noexcept;  ///< rad or m from now to standstill, signed
  double deceleration(int joint) const { return deceleration_[static_cast<std::size_t>(joint)]; }

 private:
  BrakingKind kind_;
  double reaction_time_, stop_time_{0.0};
  config::JointNumbers max_deceleration_, deceleration_;  ///< decelerations: allowed, and on this path
  std::vector<double> q_, qd_;
};

}  // namespace abstand::safety
