// How a mechanism comes to rest: joint values over time, and how far it gets.
#pragma once

#include <span>
#include <vector>

#include "core/config/number_rule.hpp"

namespace abstand::safety {

/// kEachJoint: each joint slows down by its own deceleration and stands when it stands. kTogether: all joints
/// stop at once, in the time that the slowest needs, so the mechanism stays on a line in joint space: the
/// path it was on, to first order.
enum class BrakingKind { kEachJoint, kTogether };

struct BrakingOptions {
  static constexpr const char* kName = "braking";
  static constexpr config::NumberRule kDecelerationRule{0.0, 1e6, "rad/s^2 or m/s^2", true};
  config::JointNumbers deceleration{5.0};  ///< rad/s^2 or m/s^2, of each joint or one for all
  double reaction_time{0.01};  ///< s, for which the joints go on as they are before they slow down
  BrakingKind kind{BrakingKind::kEachJoint};

  template <class Self, class Visit>
  static void eachNumber(Self& o, Visit visit) {
    visit("reaction_time", o.reaction_time, config::NumberRule{0.0, 10.0, "s"});
  }
};

/// Constant decelerations after a reaction time. Sizes are fixed when it is made; start() and all below do
/// not allocate. SI.
class BrakingPath {
 public:
  /// Throws UsageError for options that are not allowed for `dof` joints.
  BrakingPath(const BrakingOptions& options, int dof);

  /// From these joint values and velocities. False, and the path stands still at q, when something is not
  /// finite: then nothing is certain. `q` and `qd` have the size dof.
  bool start(std::span<const double> q, std::span<const double> qd) noexcept;

  int dof() const { return static_cast<int>(q_.size()); }
  double q(int joint, double t) const noexcept;
  double qd(int joint, double t) const noexcept;
  void at(double t, std::span<double> q) const noexcept;
  /// Of its size, the highest velocity from t0 on.
  double fastest(int joint, double t0) const noexcept;
  double stopTime(int joint) const noexcept;  ///< s, from now, reaction time included
  double stopTime() const noexcept { return stop_time_; }
  double way(int joint) const noexcept;  ///< rad or m from now to rest, with its sign
  double deceleration(int joint) const { return now_[static_cast<std::size_t>(joint)]; }

 private:
  BrakingKind kind_;
  double reaction_time_, stop_time_{0.0};
  config::JointNumbers most_, now_;  ///< decelerations: allowed, and on this path
  std::vector<double> q_, qd_;
};

}  // namespace abstand::safety
