// Hierarchy of a file as a tree with lengths.
#pragma once

#include <span>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::tracking {

/// One branch: its nodes from the joint where it leaves the rest to the end of its longest path. Joints that
/// coincide with the one before are left out.
struct TreeBranch {
  int from{-1};               ///< joint that it leaves
  std::vector<int> nodes;     ///< joints of the file
  std::vector<double> along;  ///< for each node: length of the path from `from`
  double length{0.0};         ///< of the whole path
};

/// Two branches of one joint with the same lengths: legs, arms, eyes, ...
struct BranchPair {
  TreeBranch a, b;
};

/// Joints with their parents and rest positions, in the units of the file. Work and memory are linear in the
/// number of joints, as branches and pairs are limited.
class SkeletonTree {
 public:
  /// `parents`: index, smaller than the own; -1 for roots. Positions are finite.
  SkeletonTree(std::span<const int> parents, std::span<const Vector3d> positions);

  /// Pairs of symmetric branches, of at most kMaxBranches branches at a joint.
  std::vector<BranchPair> symmetricPairs() const;
  /// The branch that begins with the joint `child`.
  TreeBranch branch(int child) const;
  const std::vector<int>& children(int joint) const { return children_[static_cast<std::size_t>(joint)]; }
  /// True if `joint` is `ancestor` or lies below it.
  bool isBelow(int joint, int ancestor) const;
  /// Joints strictly between two, from a to b, over their common ancestor; without the ancestor's coincident
  /// joints.
  std::vector<int> between(int a, int b) const;

 private:
  std::span<const int> parents_;
  std::span<const Vector3d> p_;
  std::vector<std::vector<int>> children_;
  std::vector<double> own_, below_;  ///< length of the bone to the parent; longest path below
  std::vector<int> longest_;         ///< child with the longest path, -1: none
};

inline constexpr std::size_t kMaxBranches = 10;      // of one joint
inline constexpr std::size_t kMaxBranchNodes = 24;   // of one branch
inline constexpr std::size_t kMaxBranchPairs = 200;  // of one skeleton

}  // namespace abstand::tracking
