// Joint motion with continuous velocities and accelerations.
#pragma once

#include "core/mechanism/motion_file.hpp"

namespace abstand::mechanism {

/// Cubic splines through the rows of a recorded motion, at rest at both ends [clamped splines; de Boor, A
/// Practical Guide to Splines, IV]. Velocity and acceleration are continuous, so that torques are finite.
/// Constant after construction; shared by all threads.
class SmoothMotion {
 public:
  explicit SmoothMotion(const MotionTable& table);

  int dof() const { return dof_; }
  double start() const { return t_.front(); }
  double end() const { return t_.back(); }

  /// Joint values, rates and accelerations at time t (s), SI; outside of the rows at rest at the first or
  /// last one. Each span has size dof(). No allocation, no throw.
  void at(double t, std::span<double> q, std::span<double> qd, std::span<double> qdd) const;

 private:
  std::vector<double> t_, q_;
  std::vector<double> slopes_;  ///< qd at the rows, row by row
  int dof_;
};

}  // namespace abstand::mechanism
