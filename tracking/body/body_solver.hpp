// One Gauss-Newton solver for joints, markers and depth: rows in, a better pose out.
#pragma once

#include "tracking/body/body_rig.hpp"

namespace abstand::tracking {

/// Collects the rows of a least-squares problem about one pose of a rig and takes a step.
///
/// A row says of a point that is fixed to a segment: moved by v, its residual becomes r + n . v (m), weight w
/// (1/m^2). As all rows of a segment share its motion, they are summed as 6 x 6 matrices of its twist, and
/// these from the leaves to the root, as composite inertias are (Featherstone 2008, chapter 6): a thousand
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

  /// The point now at p_W; n unit vector, world.
  void addPlane(RigSegment s, const Vector3d& p_W, const Vector3d& n, double r, double w);
  /// The point now at p_W shall be at `goal`: three rows.
  void addPoint(RigSegment s, const Vector3d& p_W, const Vector3d& goal, double w);
  /// A degree of freedom shall change by `wish` (rad, m), weight w (1/rad^2, 1/m^2).
  void addFreedom(int column, double wish, double w);
  /// Every degree of freedom shall become that of `other`; w by freedom.
  void addPrior(const RigPose& other, const Vector& w);
  /// Joints beyond their limits are driven back; w (1/rad^2).
  void addLimits(double w);

  /// Levenberg's step: (H + damping * I) d = -g, d shortened so that no freedom turns or moves more than
  /// `most` (rad, m). Hinges end within their limits. Gives the largest change.
  double step(double damping, double most);

  /// The sum over all rows of the last problem, w r^2, before the step.
  double cost() const { return cost_; }
  /// H of the last problem, complete after step().
  const Matrix& information() const { return H_; }
  /// How p_W, fixed to `s`, moves with each freedom: 3 x freedoms, of the pose of begin().
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

/// `pose` with every freedom changed by `d` (rad, m). Balls and the pelvis turn about the axes of their
/// parent (the pelvis: of the world, about its origin).
void advance(const BodyRig& rig, const BodySolver::Vector& d, RigPose& pose);

/// The change that leads from `from` to `to`, to first order the inverse of advance().
BodySolver::Vector difference(const BodyRig& rig, const RigPose& from, const RigPose& to);

}  // namespace abstand::tracking
