// One reading of a tree as a person: which branches are legs, arms and head.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "tracking/joint_guess/limb_choice.hpp"
#include "tracking/joint_guess/skeleton_tree.hpp"

namespace abstand::tracking {

/// Legs or arms.
struct Limbs {
  BranchPair pair;
  LimbChoice choice;
  double length() const { return choice.upper + choice.lower; }
};

struct ShapeReading {
  Limbs legs;
  std::optional<Limbs> arms;  ///< nullopt: a figure without arms
  TreeBranch head;            ///< from the neck, or from the head if the neck is the chest
  int chest{-1};              ///< joint that arms and head leave
  int top{-1};                ///< joint above the hips, for the direction of the trunk
  double cost{0.0};

  int hips() const { return legs.pair.a.from; }
};

/// Positions of all joints at one time.
using Places = std::span<const Vector3d>;
inline const Vector3d& at(Places p, int joint) { return p[static_cast<std::size_t>(joint)]; }

/// From the hips along the trunk, in the units of the file.
inline Vector3d upOf(const ShapeReading& r, Places p) { return at(p, r.top) - at(p, r.hips()); }

/// From the same joint of branch b to that of branch a, where the limbs begin.
inline Vector3d acrossOf(const Limbs& limbs, Places p) {
  return at(p, limbs.pair.a.nodes[limbs.choice.first]) - at(p, limbs.pair.b.nodes[limbs.choice.first]);
}

/// Cosine; 0 for a vector of no length.
inline double cosineOf(const Vector3d& a, const Vector3d& b) {
  const double length = a.norm() * b.norm();
  return length > 0.0 ? a.dot(b) / length : 0.0;
}

}  // namespace abstand::tracking
