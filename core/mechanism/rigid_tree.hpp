// Rigid body tree for dynamics: moving bodies, each with one joint.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/mechanism/mechanism.hpp"

namespace abstand::mechanism {

/// One body: everything that moves with one joint. Its frame is that joint's frame, after the joint.
struct TreeBody {
  int parent{-1};  ///< index of the body that carries the joint, below its own; -1: the base
  int frame{0};    ///< index of the joint's frame in Mechanism::frames
  bool prismatic{false};
  int dof{0};  ///< index into q; bodies of mimic joints share one
  double offset{0.0}, scale{1.0};
  bool about_z{true};                     ///< the axis is z
  Vector3d axis{Vector3d::UnitZ()};       ///< unit, in the body's axes
  Transform X_PJ{Transform::Identity()};  ///< joint at value 0, in the parent body's frame or the base
  double mass{0.0};                       ///< kg
  Vector3d com{Vector3d::Zero()};         ///< m, centre of mass in the body's frame
  Matrix3d inertia{Matrix3d::Zero()};     ///< kg m^2, about the centre of mass, in the body's axes
};

/// Constant after makeRigidTree(); shared by all threads. Parents precede their children.
struct RigidTree {
  int dof{0};
  std::vector<TreeBody> bodies;

  /// Location of a frame of the mechanism: fixed in a body, or in the base (-1).
  struct Place {
    int body{-1};
    Transform X_TF{Transform::Identity()};  ///< the frame in its body's frame, or in the base
  };
  std::vector<Place> frames;  ///< by index of the frame
};

/// Frames that cannot move relative to their parent (fixed ones, and variables without a dof) become part of
/// the parent's body, with their mass. Bodies fixed to the base have no dynamics. `mechanism` is prepared.
RigidTree makeRigidTree(const Mechanism& mechanism);

/// Expresses the tree in a frame N in which its base is at X_NB: "base" below then means N.
void moveBase(RigidTree& tree, const Transform& X_NB);

/// State of one body. All in base axes.
struct TreeBodyState {
  Matrix3d R_B;             ///< the body's axes
  Vector3d p_B;             ///< origin of the body's frame
  Vector3d axis_B;          ///< the joint's axis times its scale: motion for each unit of q
  Vector3d arm_B;           ///< from the parent's (or base's) origin to the body's
  Vector3d com_B;           ///< from the body's origin to its centre of mass
  Vector3d omega, alpha;    ///< rad/s, rad/s^2
  Vector3d velocity;        ///< m/s, of the origin; only for velocityOf() and kinetic energy
  Vector3d acceleration;    ///< m/s^2, of the origin
  Vector3d force, moment;   ///< N, N m about the body's origin
  double mass;              ///< kg, of the body and all that it carries (composite body)
  Vector3d first_moment;    ///< kg m, composite mass times the vector from the body's origin to its centre of
                            ///< mass
  Matrix3d inertia_origin;  ///< kg m^2, composite inertia about the body's origin
};

/// Scratch, one per thread.
struct TreeState {
  std::vector<TreeBodyState> bodies;
};

/// Computes axes, origins and arms of all bodies for the joint values `q` (rad, m; size tree.dof). No
/// allocation after the first call with the same state.
void placeBodies(const RigidTree& tree, std::span<const double> q, TreeState& state);

/// Computes the velocities of all bodies (`omega`, `velocity`, base axes) for the rates `qd`. After
/// placeBodies().
void moveBodies(const RigidTree& tree, std::span<const double> qd, TreeState& state);

/// Pose of frame `frame` (index) in the base, after placeBodies().
Transform poseOfFrame(const RigidTree& tree, const TreeState& state, int frame);

/// Adds J^T w to `efforts` (size dof) for the wrench `w` (base axes, torque about the point `p_B`) on body
/// `body` (-1, the base: none). After placeBodies().
void addBodyEfforts(const RigidTree& tree, const TreeState& state, int body, const Vector3d& p_B,
                    const Wrench& w, std::span<double> efforts);

}  // namespace abstand::mechanism
