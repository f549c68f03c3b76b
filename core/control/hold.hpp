// Keeps a robot at its planned motion, softly enough to be pushed away from it.
#pragma once

#include <span>
#include <vector>

#include "core/config/number_rule.hpp"

namespace abstand::control {

struct HoldOptions {
  static constexpr const char* kName = "hold";
  /// rad/s, omega: how fast it comes back, and how stiff it is: a mass m that is pushed feels like on a
  /// spring of m omega^2. 6 rad/s: at 2 kg 72 N/m, and back within half a second.
  double frequency{6.0};
  double damping{1.0};  ///< zeta; 1: back without overshoot

  template <class Self, class Visit>
  static void eachNumber(Self& o, Visit visit) {
    visit("frequency", o.frequency, config::NumberRule{0.0, 1000.0, "rad/s", true});
    visit("damping", o.damping, config::NumberRule{0.0, 10.0});
  }
};

/// What a robot was told to do at one moment. All of the size dof.
struct PlannedMotion {
  std::span<const double> q, qd, qdd;  ///< rad or m, and per s, per s^2
};

/// The accelerations to be asked for [computed torque; Craig, Introduction to Robotics, 10.4]:
///   a = qdd_p + 2 zeta omega (qd_p - qd) + omega^2 (q_p - q)
/// With the efforts M a + C qd + g of a perfect model each joint returns like a pendulum of omega and zeta,
/// whatever the links weigh, and a push tau moves it by M^-1 tau. Gives `a` (size dof) in `acceleration`.
inline void hold(const HoldOptions& o, const PlannedMotion& plan, std::span<const double> q,
                 std::span<const double> qd, std::span<double> acceleration) noexcept {
  const double k = o.frequency * o.frequency, d = 2.0 * o.damping * o.frequency;
  for (std::size_t i = 0; i < acceleration.size(); ++i)
    acceleration[i] = plan.qdd[i] + d * (plan.qd[i] - qd[i]) + k * (plan.q[i] - q[i]);
}

}  // namespace abstand::control
