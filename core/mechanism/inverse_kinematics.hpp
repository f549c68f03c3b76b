// Inverse kinematics of a point on a mechanism, within the joint limits.
#pragma once

#include "core/mechanism/dof_limits.hpp"
#include "core/mechanism/mechanism.hpp"

namespace abstand::mechanism {

/// Joint values that bring a point of a frame to a target, by damped least squares: each step minimises
///   |J dq - e|^2 + lambda^2 |dq|^2,   dq = J^T (J J^T + lambda^2 I)^-1 e,
/// with the point's Jacobian J (3 x dof) and its error e, over the joints that are not held by a limit
/// [Wampler 1986, Nakamura and Hanafusa 1986; lambda as in Levenberg and Marquardt: a step counts only if it
/// comes nearer]. Rotations and translations of joints weigh alike (1 rad as 1 m). For a target out of reach
/// the result is a point from which no small motion within the limits comes nearer. Only the constructor
/// allocates or throws. One thread.
class PointReach {
 public:
  struct Options {
    double tolerance{1e-6};  ///< m, distance from the target that ends the search
    int iterations{100};     ///< at most, steps that do not come nearer included
  };
  struct Result {
    double distance{kNaN};  ///< m, of the point from the target
    int iterations{0};
  };

  /// Throws UsageError for a frame that the mechanism does not have. The mechanism must outlive this object.
  PointReach(const Mechanism& mechanism, int frame, const Options& options);
  PointReach(const Mechanism& mechanism, int frame) : PointReach(mechanism, frame, Options()) {}

  /// `q` (rad, m; size dof): where the search begins, clamped to the limits; then the result, within the
  /// limits. `p_F`: the point in the frame; `p_B`: the target in the base frame. Both m. With a start or a
  /// target that is not finite nothing changes, and the distance is NaN.
  Result solve(const Vector3d& p_F, const Vector3d& p_B, std::span<double> q) noexcept;

 private:
  Vector3d point(std::span<const double> q, const Vector3d& p_F);
  void findJacobian(const Vector3d& p_B);
  double step(std::span<const double> q, const Vector3d& error, double lambda);
  bool isHeld(std::span<const double> q, Eigen::Index joint, double direction) const;

  const Mechanism& mechanism_;
  int frame_;
  Options options_;
  std::vector<DofLimits> limits_;
  MechanismState state_;
  Eigen::Matrix<double, 6, Eigen::Dynamic> J_frame_;
  Eigen::Matrix<double, 3, Eigen::Dynamic> J_, J_free_;
  Eigen::VectorXd dq_;
  std::vector<double> next_;  ///< q after a step
};

}  // namespace abstand::mechanism
