// A mechanism: a tree of frames joined by fixed, revolute and prismatic joints.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::mechanism {

enum class JointType { kFixed, kRevolute, kPrismatic };

/// Limits of a joint in the units of its value (rad or m). Infinity: no limit.
struct JointLimits {
  double lower{-kInfinity}, upper{kInfinity};
  double velocity{kInfinity};      ///< rad/s or m/s, absolute value
  double effort{kInfinity};        ///< N m or N, absolute value
  double acceleration{kInfinity};  ///< rad/s^2 or m/s^2, absolute value
};

/// Mass properties of the body that moves with a frame. SI; 0 if unknown.
struct LinkInertia {
  double mass{0.0};
  Vector3d com_F{Vector3d::Zero()};      ///< centre of mass in the frame
  Matrix3d inertia_F{Matrix3d::Zero()};  ///< kg m^2, about the centre of mass, in the frame's axes
};

/// One frame i, relative to its parent. In a `.mech` file by the modified (Craig) Denavit-Hartenberg
/// convention, T = RotX(alpha) TransX(a) RotZ(theta) TransZ(d); otherwise (`has_dh` false) by a constant X_PJ
/// followed by the joint about or along `axis`. SI. The value of a variable joint is offset + scale * q[dof];
/// several frames may share a dof (mimic joints).
struct MechanismFrame {
  int id{0};          ///< unique, positive; 0 is the base
  std::string name;   ///< the id as text for .mech files, the link's name for URDF
  std::string joint;  ///< name of the joint that moves it, if the file has one
  int parent{-1};     ///< index into Mechanism::frames, -1 for the base
  JointType type{JointType::kFixed};
  double a{0.0}, alpha{0.0}, d{0.0}, theta{0.0};  ///< the variable one is 0
  int dof{-1};  ///< index into q; -1 if fixed (or a variable without a `dof` mapping: it stays 0)
  double offset{0.0}, scale{1.0};
  bool mimic{false};  ///< follows a dof led by another frame
  bool has_center{false};
  Transform X_FC{Transform::Identity()};  ///< `link` environment: centre of the link in its frame
  bool has_dh{true};
  /// Constant part of the transform; set by Mechanism::prepare() if has_dh, otherwise by the creator of the
  /// frame.
  Transform X_PJ{Transform::Identity()};
  Vector3d axis{Vector3d::UnitZ()};  ///< unit vector in the frame's axes; rotation about it or translation
                                     ///< along it
  JointLimits limits;                ///< of the joint's value
  LinkInertia inertia;
};

/// Constant after prepare(); shared by all threads. Parents precede their children in `frames`.
struct Mechanism {
  std::string name;
  std::vector<MechanismFrame> frames;
  int dof{0};
  bool prepared{false};  ///< forward() aborts the program if false

  /// Index of the frame with this id, or -1.
  int indexOf(int id) const;
  /// Index of the frame with this name, or -1.
  int indexOf(const std::string& frame_name) const;

  /// Computes the parts that do not depend on q. Called by the readers of files; call it after building or
  /// changing a mechanism by hand.
  void prepare();
};

/// Poses of all frames in the base frame; scratch, one per thread.
struct MechanismState {
  std::vector<Transform> X_BF;
};

/// Poses of all frames for the joint values `q` (rad, m; size mechanism.dof) [Craig, Introduction to
/// Robotics, eq. 3.6; thesis 3.1.3]. No allocation after the first call with the same state.
void forward(const Mechanism& mechanism, std::span<const double> q, MechanismState& state);

/// Jacobian of frame `index`, 6 x dof: rows are the linear velocity of its origin, then the angular velocity,
/// base axes, for each unit of q (rad, m). `state` comes from forward(). No allocation if `J` already has
/// that size.
void jacobian(const Mechanism& mechanism, const MechanismState& state, int index,
              Eigen::Matrix<double, 6, Eigen::Dynamic>& J);

/// Adds J^T w to `efforts` (size dof; N m for revolute, N for prismatic joints): the joint efforts caused by
/// the wrench `w` (base axes, torque about the point `p_B`, base frame) on the body of frame `index`.
void addJointEfforts(const Mechanism& mechanism, const MechanismState& state, int index, const Vector3d& p_B,
                     const Wrench& w, std::span<double> efforts);

}  // namespace abstand::mechanism
