// Efforts on each joint of a moving mechanism.
#pragma once

#include <span>
#include <vector>

#include "app/session/mechanism_driver.hpp"
#include "core/mechanism/inverse_dynamics.hpp"
#include "core/mechanism/smooth_motion.hpp"
#include "core/view/snapshot.hpp"

namespace abstand::session {

/// The gravity and motion parts of TorqueParts, by inverse dynamics:
///   gravity = -g(q), motion = -(M(q) qdd + C(q, qd) qd).
/// One thread; update() does not allocate after its first call, and does not throw.
class JointTorques {
 public:
  /// The driver must outlive this object.
  explicit JointTorques(const MechanismDriver& driver);

  /// Sets gravity and motion in `out` (size dof) in the driver's current posture, with `qd` and `qdd` (rad/s,
  /// rad/s^2 or m/s, m/s^2). NaN if the mechanism's file has no masses.
  void update(std::span<const double> qd, std::span<const double> qdd, std::span<view::TorqueParts> out);
  /// The same for the recorded motion at time t (s); at rest if there is none.
  void updateRecorded(double t, std::span<view::TorqueParts> out);
  /// The same for a mechanism that stands still.
  void updateAtRest(std::span<view::TorqueParts> out);

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
