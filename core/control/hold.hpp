// Joint hold: computed torque control of the planned motion, compliant to pushes.
#pragma once

#include <span>
#include <vector>

#include "core/config/number_rule.hpp"

namespace abstand::control {

struct HoldOptions {
  static constexpr const char* kName = "hold";
  /// rad/s, omega: speed of return and stiffness. A pushed mass m feels a spring of m omega^2. 6 rad/s: 72
  /// N/m at 2 kg, and return within half a second.
  double frequency{6.0};
  double damping{1.0};  ///< zeta; 1: return without overshoot

  template <class Self, class Visit>
  static void eachNumber(Self& o, Visit visit) {
    visit("frequency", o.frequency, config::NumberRule{0.0, 1000.0, "rad/s", true});
    visit("damping", o.damping, config::NumberRule{0.0, 10.0});
  }
};

/// Planned motion at one time. All of size dof.
struct PlannedMotion {
  std::span<const double> q, qd, qdd;  ///< rad or m, and per s, per s^2
};

/// Commanded accelerations [computed torque; Craig, Introduction to Robotics, 10.4]:
///   a = qdd_p + 2 zeta omega (qd_p - qd) + omega^2 (q_p - q)
/// With the efforts M a + C qd + g of a perfect model each joint returns as a second-order system of omega
/// and zeta, independent of the links' masses, and a torque tau displaces it by M^-1 tau. Writes `a` (size
/// dof) to `acceleration`.
inline void hold(const HoldOptions& o, const PlannedMotion& plan, std::span<const double> q,
                 std::span<const double> qd, std::span<double> acceleration) noexcept {
  const double k = o.frequency * o.frequency, d = 2.0 * o.damping * o.frequency;
  for (std::size_t i = 0; i < acceleration.size(); ++i)
    acceleration[i] = plan.qdd[i] + d * (plan.qd[i] - qd[i]) + k * (plan.q[i] - q[i]);
}

}  // namespace abstand::control
