// Repulsive potential around a robot's links, with damping by effective mass.
#pragma once

#include "core/config/number_rule.hpp"

namespace abstand::control {

/// SI.
struct RepulsionOptions {
  static constexpr const char* kName = "repulsion";
  double range{0.1};          ///< m, d_0: no force at larger distances
  double force{50.0};         ///< N, F_max: force at distance 0 and inside
  double damping{0.7};        ///< zeta; 1: critical at each distance
  double mass{5.0};           ///< kg, effective mass if no mass matrix is known
  double stop_distance{0.0};  ///< m; motion towards the other body must have stopped at this distance
  /// 0 to 1. Usable share of the potential energy down to `stop_distance`; a larger kinetic energy of a link
  /// requires an emergency stop. 0: any approach within range does.
  double stop_share{1.0};

  template <class Self, class Visit>
  static void eachNumber(Self& o, Visit visit) {
    visit("range", o.range, config::NumberRule{0.0, 10.0, "m", true});
    visit("force", o.force, config::NumberRule{0.0, 1e6, "N"});
    visit("damping", o.damping, config::NumberRule{0.0, 10.0});
    visit("mass", o.mass, config::NumberRule{0.0, 1e4, "kg", true});
    visit("stop_distance", o.stop_distance, config::NumberRule{0.0, 10.0, "m"});
    visit("stop_share", o.stop_share, config::NumberRule{0.0, 1.0});
  }
  /// Throws UsageError, also for a stop_distance that is not below the range.
  void validate() const;
};

/// Result for one pair.
struct RepulsionResult {
  double force{0.0};      ///< N, along the separating direction; never negative
  double kinetic{0.0};    ///< J, of the robot's own approach; 0 if it recedes
  double available{0.0};  ///< J, remaining energy that the potential can absorb before stop_distance
  bool stop{false};       ///< kinetic > stop_share * available, and more than a microjoule, within range
};

/// After Dietrich, Wimboeck, Taeubig, Albu-Schaeffer, Hirzinger 2011, Extensions to Reactive Self-Collision
/// Avoidance for Torque and Position Controlled Humanoids (the thesis's [6]), independently formulated: a
/// cubic potential, damping by the effective mass along the pair's direction, and a stop by kinetic energy.
/// With d the distance and e = d_0 - d:
///   V(d) = F_max e^3 / (3 d_0^2),  F = -dV/dd = F_max e^2 / d_0^2,  K = -dF/dd = 2 F_max e / d_0^2
///   f = max(0, F - D ddot),  D = 2 zeta sqrt(K m)
/// for 0 <= d <= d_0; beyond, all are 0; inside, F and K use d = 0, so V grows linearly. Force and stiffness
/// are continuous at d_0. m is the effective mass along the direction (see effectiveMass()), so a light wrist
/// is damped less than a heavy shoulder. The force never attracts, and d/dt (E_kin + V) = (f - F) ddot <= 0.
class Repulsion {
 public:
  explicit Repulsion(const RepulsionOptions& options);  ///< throws UsageError

  const RepulsionOptions& options() const { return o_; }
  double potential(double distance) const noexcept;  ///< J
  double force(double distance) const noexcept;      ///< N
  double stiffness(double distance) const noexcept;  ///< N/m
  /// @param distance  m, preferably a lower bound of the true one; NaN counts as 0
  /// @param rate      m/s, of the distance: negative when approaching
  /// @param own_rate  m/s, the part of `rate` caused by the robot. Only this can be stopped by braking, so a
  ///                  robot at rest yields to an approaching fist and does not engage its brakes
  /// @param mass      kg, effective along the direction, > 0
  RepulsionResult update(double distance, double rate, double own_rate, double mass) const noexcept;

 private:
  RepulsionOptions o_;
};

}  // namespace abstand::control
