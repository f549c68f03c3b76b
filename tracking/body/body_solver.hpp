// Gauss-Newton solver for joints, markers and depth: collects rows, returns a better pose.
#pragma once

#include "tracking/body/body_rig.hpp"

namespace abstand::tracking {

/// Accumulates a least-squares problem around one pose of a rig and takes a step.
///
/// A row is for a point fixed to a segment: moved by v, its residual becomes r + n . v (m), weight w (1/m^2).
/// Rows of a segment depend on its motion only, so they are summed as a 6 x 6 matrix of its twist, and these
/// matrices from the leaves to the root, like composite inertias (Featherstone 2008, chapter 6): a thousand
/// points cost little more than one.
///
/// Not shared between threads. No allocation, no throw.
class BodySolver {
 public:
  using Vector = Eigen::Matrix<double, kRigDof, 1>;
  using Matrix = Eigen::Matrix<double, kRigDof, kRigDof>;

  explicit BodySolver(const BodyRig& rig) : rig_{&rig} {}

  /// Starts a new problem about `pose`.
  void begin(const RigPose& pose);
  const RigPose& pose() const { return pose_; }
  const RigPlacement& placement() const { return X_WS_; }

  /// Point at p_W with the residual r along n (unit vector, world).
  void addPlane(RigSegment s, const Vector3d& p_W, const Vector3d& n, double r, double w);
  /// The point at p_W should be at `goal`: three rows.
  void addPoint(RigSegment s, const Vector3d& p_W, const Vector3d& goal, double w);
  /// A dof should change by `target` (rad, m), weight w (1/rad^2, 1/m^2).
  void addFreedom(int column, double target, double w);
  /// Every dof should become that of `other`; weights w for each dof.
  void addPrior(const RigPose& other, const Vector& w);
  /// Penalty of joints beyond their limits; w (1/rad^2).
  void addLimits(double w);
  /// The twist of a ball's segment about its own axis should be 0; w (1/rad^2).
  void addUntwist(RigSegment ball, double w);

  /// Levenberg step: (H + damping * I) d = -g, with d scaled so that no dof changes by more than `most` (rad,
  /// m). Hinges end within their limits. Returns the largest change.
  double step(double damping, double max_step);

  /// Sum of w r^2 over all rows of the last problem, before the step.
  double cost() const { return cost_; }
  /// H of the last problem, complete after step().
  const Matrix& information() const { return H_; }
  /// Jacobian of p_W, fixed to `s`, by the dof: 3 x kRigDof, at the pose of begin().
  Eigen::Matrix<double, 3, kRigDof> jacobian(RigSegment s, const Vector3d& p_W) const;

 private:
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  using Matrix6 = Eigen::Matrix<double, 6, 6>;

  void addWrench(std::size_t segment, const Vector6& wrench, double r, double w);
  void assemble();

  const BodyRig* rig_;
  RigPose pose_;
  RigPlacement X_WS_;
  Vector3d origin_{Vector3d::Zero()};    ///< of the root at begin(), world
  Eigen::Matrix<double, 6, kRigDof> S_;  ///< twists (v at the root's origin, omega), world axes
  std::array<std::size_t, kRigDof> segment_of_{};
  std::array<Matrix6, kRigSegments> A_;
  std::array<Vector6, kRigSegments> b_;
  Matrix H_;
  Vector g_;
  double cost_{0.0};
};

/// Changes every dof of `pose` by `d` (rad, m). Balls and the pelvis rotate about the axes of their parent
/// (the pelvis: of the world, about its origin).
void advance(const BodyRig& rig, const BodySolver::Vector& d, RigPose& pose);

/// The change from `from` to `to`; to first order the inverse of advance().
BodySolver::Vector difference(const BodyRig& rig, const RigPose& from, const RigPose& to);

}  // namespace abstand::tracking
