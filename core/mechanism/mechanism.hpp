// A mechanism: a tree of frames joined by fixed, revolute and prismatic joints.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand {

enum class JointType { kFixed, kRevolute, kPrismatic };

/// One frame i of the modified (Craig) Denavit-Hartenberg convention, relative to its parent:
/// T = RotX(alpha) TransX(a) RotZ(theta) TransZ(d). SI. A variable joint's value is offset + scale * q[dof].
struct MechanismFrame {
  int id{0};         ///< unique, positive; 0 is the base
  std::string name;  ///< the id as text for .mech files
  int parent{-1};    ///< index into Mechanism::frames, -1 for the base
  JointType type{JointType::kFixed};
  double a{0.0}, alpha{0.0}, d{0.0}, theta{0.0};  ///< the variable one holds 0
  int dof{-1};  ///< index into q, -1 when fixed (or a variable that no `dof` maps: it stays 0)
  double offset{0.0}, scale{1.0};
  bool has_center{false};
  Transform X_FC{Transform::Identity()};  ///< `link` environment: centre of the link in its frame
  Transform X_PJ{Transform::Identity()};  ///< constant part of the transform, set by Mechanism::prepare()
};

/// Constant after prepare(); shared by all threads. Frames stand in an order in which parents come first.
struct Mechanism {
  std::string name;
  std::vector<MechanismFrame> frames;
  int dof{0};
  bool prepared{false};  ///< forward() stops the program when it is not

  /// Index of the frame with this id, or -1.
  int indexOf(int id) const;

  /// Computes what does not depend on q, once. The readers of files call it; who builds or changes a
  /// mechanism by hand calls it afterwards.
  void prepare();
};

/// Poses of all frames in the base frame; scratch, one per thread.
struct MechanismState {
  std::vector<Transform> X_BF;
};

/// Poses of all frames for the joint values `q` (rad, m; size mechanism.dof) [Craig, Introduction to
/// Robotics, eq. 3.6; thesis 3.1.3]. No allocation after the first call with the same state.
void forward(const Mechanism& mechanism, std::span<const double> q, MechanismState& state);

/// 6 x dof, rows: linear velocity of frame `index`'s origin, then angular velocity, base axes, per unit of q
/// (rad, m). `state` comes from forward(). No allocation when `J` has that size already.
void jacobian(const Mechanism& mechanism, const MechanismState& state, int index,
              Eigen::Matrix<double, 6, Eigen::Dynamic>& J);

/// Adds J^T w to `efforts` (size dof; N m for revolute, N for prismatic): the joint efforts that the wrench
/// `w` (base axes, torque about the point `p_B`, base frame) acting on the body of frame `index` causes.
void addJointEfforts(const Mechanism& mechanism, const MechanismState& state, int index, const Vector3d& p_B,
                     const Wrench& w, std::span<double> efforts);

}  // namespace abstand
