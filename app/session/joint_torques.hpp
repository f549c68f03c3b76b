// What acts on each joint of a mechanism that moves.
#pragma once

#include <span>
#include <vector>

#include "app/session/mechanism_driver.hpp"
#include "core/mechanism/inverse_dynamics.hpp"
#include "core/mechanism/smooth_motion.hpp"
#include "core/view/snapshot.hpp"

namespace abstand::session {

/// The parts of TorqueParts that come from gravity and from the motion itself, by inverse dynamics:
///   gravity = -g(q), motion = -(M(q) qdd + C(q, qd) qd).
/// One thread; update() allocates nothing after its first call and throws nothing.
class JointTorques {
 public:
  /// The driver must outlive it.
  explicit JointTorques(const MechanismDriver& driver);

  /// Sets gravity and motion in `out` (size dof) at the driver's present posture, moving with `qd` and `qdd`
  /// (rad/s, rad/s^2 or m/s, m/s^2). NaN where the mechanism's file names no masses.
  void update(std::span<const double> qd, std::span<const double> qdd, std::span<view::TorqueParts> out);
  /// The same on the recorded motion at time t (s); at rest without one.
  void updateRecorded(double t, std::span<view::TorqueParts> out);

 private:
  const MechanismDriver& driver_;
  std::optional<mechanism::SmoothMotion> motion_;
  mechanism::RigidTree tree_;
  mechanism::TreeState state_;
  Vector3d gravity_B_;
  bool weighs_{false};
  std::vector<double> q_, qd_, qdd_, efforts_;
};

}  // namespace abstand::session
