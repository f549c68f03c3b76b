// A joint motion with velocities and accelerations.
#pragma once

#include "core/mechanism/motion_file.hpp"

namespace abstand::mechanism {

/// A recorded motion made smooth: cubic splines through its rows, at rest at its ends [clamped splines; de
/// Boor, A Practical Guide to Splines, IV]. Velocity and acceleration are continuous, so that torques for it
/// are finite. Constant after construction; shared by all threads.
class SmoothMotion {
 public:
  explicit SmoothMotion(const MotionTable& table);

  int dof() const { return dof_; }
  double start() const { return t_.front(); }
  double end() const { return t_.back(); }

  /// Joint values, rates and accelerations at time t (s), in SI; outside of the rows, at rest at the first or
  /// last. Each has dof() places. No allocation, no throw.
  void at(double t, std::span<double> q, std::span<double> qd, std::span<double> qdd) const;

 private:
  std::vector<double> t_, q_;
  std::vector<double> slopes_;  ///< qd at the rows, row by row
  int dof_;
};

}  // namespace abstand::mechanism
