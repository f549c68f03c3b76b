// Bodies of a mechanism, their poses and velocities.
#include "core/mechanism/rigid_tree.hpp"

#include <cmath>

#include "core/base/error.hpp"
#include "core/mechanism/link_inertia.hpp"

namespace abstand::mechanism {
namespace {

/// Joint transform of a frame that cannot move.
Transform standing(const MechanismFrame& f) {
  if (f.type == JointType::kRevolute) return f.X_PJ * Eigen::AngleAxisd(f.offset, f.axis);
  if (f.type == JointType::kPrismatic) return f.X_PJ * Eigen::Translation3d(f.offset * f.axis);
  return f.X_PJ;
}

}  // namespace

RigidTree makeRigidTree(const Mechanism& mechanism) {
  ABSTAND_CHECK(mechanism.prepared);
  RigidTree tree;
  tree.dof = mechanism.dof;
  for (std::size_t i = 0; i < mechanism.frames.size(); ++i) {
    const auto& f = mechanism.frames[i];
    const RigidTree::Place parent =
        f.parent < 0 ? RigidTree::Place{} : tree.frames[static_cast<std::size_t>(f.parent)];
    if (f.dof < 0) {
      const Transform X_TF = parent.X_TF * standing(f);
      tree.frames.push_back({parent.body, X_TF});
      if (parent.body < 0) continue;
      auto& body = tree.bodies[static_cast<std::size_t>(parent.body)];
      const LinkInertia whole = together({body.mass, body.com, body.inertia}, seenFrom(X_TF, f.inertia));
      body.mass = whole.mass;
      body.com = whole.com_F;
      body.inertia = whole.inertia_F;
      continue;
    }
    TreeBody body;
    body.parent = parent.body;
    body.frame = static_cast<int>(i);
    body.prismatic = f.type == JointType::kPrismatic;
    body.dof = f.dof;
    body.offset = f.offset;
    body.scale = f.scale;
    body.about_z = f.axis == Vector3d::UnitZ();
    body.axis = f.axis;
    body.X_PJ = parent.X_TF * f.X_PJ;
    body.mass = f.inertia.mass;
    body.com = f.inertia.com_F;
    body.inertia = f.inertia.inertia_F;
    tree.frames.push_back({static_cast<int>(tree.bodies.size()), Transform::Identity()});
    tree.bodies.push_back(body);
  }
  return tree;
}

void moveBase(RigidTree& tree, const Transform& X_NB) {
  for (TreeBody& b : tree.bodies)
    if (b.parent < 0) b.X_PJ = X_NB * b.X_PJ;
  for (auto& place : tree.frames)
    if (place.body < 0) place.X_TF = X_NB * place.X_TF;
}

void placeBodies(const RigidTree& tree, std::span<const double> q, TreeState& state) {
  ABSTAND_CHECK(q.size() == static_cast<std::size_t>(tree.dof));
  if (state.bodies.size() != tree.bodies.size()) state.bodies.resize(tree.bodies.size());

  for (std::size_t i = 0; i < tree.bodies.size(); ++i) {
    const TreeBody& b = tree.bodies[i];
    TreeBodyState& s = state.bodies[i];
    const double value = b.offset + b.scale * q[static_cast<std::size_t>(b.dof)];
    // The joint's frame at value 0 ...
    if (b.parent < 0) {
      s.R_B = b.X_PJ.linear();
      s.arm_B = b.X_PJ.translation();
      s.p_B = s.arm_B;
    } else {
      const TreeBodyState& p = state.bodies[static_cast<std::size_t>(b.parent)];
      s.R_B.noalias() = p.R_B * b.X_PJ.linear();
      s.arm_B.noalias() = p.R_B * b.X_PJ.translation();
      s.p_B = p.p_B + s.arm_B;
    }
    // ... and moved. A rotation about the axis leaves the axis unchanged.
    const Vector3d axis_B = b.about_z ? Vector3d(s.R_B.col(2)) : Vector3d(s.R_B * b.axis);
    s.axis_B = b.scale * axis_B;
    if (b.prismatic) {
      s.arm_B += value * axis_B;
      s.p_B += value * axis_B;
    } else if (b.about_z) {
      const double c = std::cos(value), k = std::sin(value);
      const Vector3d x_B = s.R_B.col(0), y_B = s.R_B.col(1);
      s.R_B.col(0) = c * x_B + k * y_B;
      s.R_B.col(1) = c * y_B - k * x_B;
    } else {
      s.R_B = s.R_B * Eigen::AngleAxisd(value, b.axis).toRotationMatrix();
    }
    s.com_B.noalias() = s.R_B * b.com;
  }
}

void moveBodies(const RigidTree& tree, std::span<const double> qd, TreeState& state) {
  ABSTAND_CHECK(qd.size() == static_cast<std::size_t>(tree.dof));
  ABSTAND_CHECK(state.bodies.size() == tree.bodies.size());
  for (std::size_t i = 0; i < tree.bodies.size(); ++i) {
    const TreeBody& b = tree.bodies[i];
    TreeBodyState& s = state.bodies[i];
    if (b.parent < 0) {
      s.omega.setZero();
      s.velocity.setZero();
    } else {
      const TreeBodyState& p = state.bodies[static_cast<std::size_t>(b.parent)];
      s.omega = p.omega;
      s.velocity = p.velocity + p.omega.cross(s.arm_B);
    }
    (b.prismatic ? s.velocity : s.omega) += qd[static_cast<std::size_t>(b.dof)] * s.axis_B;
  }
}

Transform poseOfFrame(const RigidTree& tree, const TreeState& state, int frame) {
  ABSTAND_CHECK(frame >= 0 && static_cast<std::size_t>(frame) < tree.frames.size());
  const auto& place = tree.frames[static_cast<std::size_t>(frame)];
  if (place.body < 0) return place.X_TF;
  const TreeBodyState& s = state.bodies[static_cast<std::size_t>(place.body)];
  Transform X_BT = Transform::Identity();
  X_BT.linear() = s.R_B;
  X_BT.translation() = s.p_B;
  return X_BT * place.X_TF;
}

void addBodyEfforts(const RigidTree& tree, const TreeState& state, int body, const Vector3d& p_B,
                    const Wrench& w, std::span<double> efforts) {
  ABSTAND_CHECK(efforts.size() == static_cast<std::size_t>(tree.dof));
  ABSTAND_CHECK(body < static_cast<int>(tree.bodies.size()) && state.bodies.size() == tree.bodies.size());
  for (int i = body; i >= 0; i = tree.bodies[static_cast<std::size_t>(i)].parent) {
    const TreeBody& b = tree.bodies[static_cast<std::size_t>(i)];
    const TreeBodyState& s = state.bodies[static_cast<std::size_t>(i)];
    efforts[static_cast<std::size_t>(b.dof)] +=
        b.prismatic ? s.axis_B.dot(w.force) : s.axis_B.dot(w.torque + (p_B - s.p_B).cross(w.force));
  }
}

}  // namespace abstand::mechanism
