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
  std::size_t common{0};  ///< number of first nodes that correspond
  double length{0.0};     ///< of both paths, as far as both go
  bool is_whole{true};    ///< false: the branches differ behind the common nodes, such as by a prop in a hand
};

/// Joints with their parents and rest positions, in the units of the file. Work and memory are linear in the
/// number of joints, as branches and pairs are limited.
class SkeletonTree {
 public:
  /// `parents`: index, smaller than the own; -1 for roots. Positions are finite.
  SkeletonTree(std::span<const int> parents, std::span<const Vector3d> positions);

  /// Pairs of symmetric branches, of at most kMaxBranches branches at a joint.
  std::vector<BranchPair> symmetricPairs() const;
  /// Pairs of branches that are not symmetric, but begin with at least three bones that are.
  std::vector<BranchPair> partlySymmetricPairs() const;
  /// The branch that begins with the joint `child`.
  TreeBranch branch(int child) const;
  /// The same, but to the joint that is highest along `up`.
  TreeBranch highestBranch(int child, const Vector3d& up) const;
  const std::vector<int>& children(int joint) const { return children_[static_cast<std::size_t>(joint)]; }
  /// True if `joint` is `ancestor` or lies below it.
  bool isBelow(int joint, int ancestor) const;
  /// Joints strictly between two, from a to b, over their common ancestor; without the ancestor's coincident
  /// joints.
  std::vector<int> between(int a, int b) const;

 private:
  /// A joint below another one, and the length of the way to it.
  struct Step {
    int joint{-1};
    double length{0.0};
  };
  /// Calls use(a, b) for all pairs of the longest branches of each joint.
  template <typename Use>
  void forPairs(const Use& use) const;
  /// The joints from `child` on without coincident ones; next(i): the joint after i, negative after the last.
  template <typename Next>
  TreeBranch branchAlong(int child, double length, const Next& next) const;
  double pathOf(int child) const {
    return own_[static_cast<std::size_t>(child)] + below_[static_cast<std::size_t>(child)];
  }
  std::vector<Step> steps(const std::vector<int>& children, double shortest) const;
  BranchPair commonPart(int a, int b) const;
  void goOn(TreeBranch& branch, double shortest) const;

  std::span<const int> parents_;
  std::span<const Vector3d> p_;
  std::vector<std::vector<int>> children_;
  std::vector<double> own_, below_;  ///< length of the bone to the parent; longest path below
  std::vector<int> longest_;         ///< child with the longest path, -1: none
};

inline constexpr std::size_t kMinPairNodes = 3;      // of both branches of a pair
inline constexpr std::size_t kMaxBranches = 10;      // of one joint
inline constexpr std::size_t kMaxBranchNodes = 24;   // of one branch
inline constexpr std::size_t kMaxBranchPairs = 200;  // of one skeleton

}  // namespace abstand::tracking
