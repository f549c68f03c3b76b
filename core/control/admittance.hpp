// Admittance control for robots that accept positions or velocities: efforts in, motion out.
#pragma once

#include <span>
#include <vector>

#include "core/config/number_rule.hpp"
#include "core/mechanism/dof_limits.hpp"

namespace abstand::control {

/// One number for all joints, or one for each.
struct AdmittanceOptions {
  static constexpr const char* kName = "admittance";
  config::JointNumbers inertia{1.0};     ///< kg m^2 or kg
  config::JointNumbers damping{10.0};    ///< N m s/rad or N s/m
  config::JointNumbers stiffness{20.0};  ///< N m/rad or N/m; 0: the offset stays where it was pushed
  config::JointNumbers velocity{1.0};    ///< rad/s or m/s, largest absolute value
  config::JointNumbers offset{0.5};      ///< rad or m, largest absolute value

  template <class Self, class Visit>
  static void eachNumber(Self&, Visit) {}
  template <class Self, class Visit>
  static void eachList(Self& o, Visit visit) {
    visit("inertia", o.inertia, config::NumberRule{0.0, 1e6, "kg m^2 or kg", true});
    visit("damping", o.damping, config::NumberRule{0.0, 1e6, "N m s/rad or N s/m"});
    visit("stiffness", o.stiffness, config::NumberRule{0.0, 1e6, "N m/rad or N/m"});
    visit("velocity", o.velocity, config::NumberRule{0.0, 1e3, "rad/s or m/s"});
    visit("offset", o.offset, config::NumberRule{0.0, 1e3, "rad or m"});
  }
};

/// Each joint behaves like m xddot + b xdot + k x = tau, with x the offset from the commanded position: a
/// virtual mass with spring and damper [interface for position controlled robots: Dietrich et al. 2011, the
/// thesis's [6]]. The step is implicit in damper and spring,
///   v' = (m v + dt (tau - k x)) / (m + dt b + dt^2 k),  x' = x + dt v',
/// so it is stable for every dt. In steady state x = tau / k, or xdot = tau / b without a spring. Velocity
/// and offset are clipped to their limits; at the offset limit the velocity is the one that leads there. One
/// thread, no allocation after construction.
class Admittance {
 public:
  /// Throws UsageError for options that are not valid for `dof` joints.
  Admittance(const AdmittanceOptions& options, int dof);

  /// Exchanges the options with those of another one of the same dof; velocity and offset stay, and are
  /// clipped in the next update. No allocation.
  void swapOptions(Admittance& other) noexcept { joints_.swap(other.joints_); }
  void reset() noexcept;  ///< offset and velocity 0
  void hold() noexcept;   ///< velocity 0, offset kept
  /// @param efforts  N m or N, size dof; values that are not finite count as 0
  /// @param dt       s; not above 0: nothing changes
  /// @param bounds   rad/s or m/s, additional bounds on its velocity; empty: none
  void update(std::span<const double> efforts, double dt,
              std::span<const mechanism::VelocityBounds> bounds = {}) noexcept;
  std::span<const double> velocity() const {
    return velocity_;
  }  ///< rad/s or m/s, to be added to the
     ///< commanded velocity
  std::span<const double> offset() const {
    return offset_;
  }  ///< rad or m, to be added to the commanded
     ///< position

 private:
  struct Joint {
    double inertia, damping, stiffness, velocity, offset;
  };
  std::vector<Joint> joints_;
  std::vector<double> velocity_, offset_;
};

}  // namespace abstand::control
