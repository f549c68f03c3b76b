// Point-sphere tree: clusters of shell points in minimal enclosing spheres.
#pragma once

#include "core/geometry/enclosing_sphere.hpp"
#include "core/shell/pointshell.hpp"

namespace abstand::shell {

/// Tree over a pointshell, at most kFanout children a node and at most kLeafPoints points a leaf. The points
/// are stored again in leaf order (structure of arrays, each leaf padded to a multiple of kLane with copies
/// of its last point whose area is 0), so that a leaf is one stretch of memory. Constant after construction.
struct PointSphereTree {
  static constexpr int kFanout = 8;
  static constexpr int kLeafPoints = 8;
  static constexpr int kLane = 8;

  struct Node {
    float cx, cy, cz;  ///< centre of the minimal enclosing sphere of the node's points (body frame, m)
    float radius;      ///< rounded up: every point of the node is inside
    std::uint32_t first_child;  ///< children are consecutive nodes
    std::uint32_t first_point;  ///< into the leaf-ordered arrays (padded)
    std::uint16_t children;     ///< 0 for a leaf
    std::uint16_t points;       ///< of a leaf: how many real points, padding not counted; of an inner node 0
  };
  /// The spheres of a node's children side by side, for a search that looks at all of them at once. Unused
  /// places have the radius -infinity, so nothing is ever near them.
  struct Family {
    float cx[kFanout], cy[kFanout], cz[kFanout], radius[kFanout];
    std::uint32_t child[kFanout];  ///< a family's index; or kLeafChild + first point / kLane
  };
  static constexpr std::uint32_t kLeafChild = 0x80000000u;

  std::vector<Node> nodes;                       ///< nodes[0] is the root; breadth-first
  std::vector<float> x, y, z, nx, ny, nz, area;  ///< leaf order, padded
  std::vector<std::uint32_t> shell_index;        ///< leaf order -> index in the Pointshell
  std::vector<Family>
      families;  ///< of the inner nodes in their order; families[0]: the root's, or the root alone
  int levels{0};

  /// A point in leaf order, and its normal.
  Vector3d at(std::uint32_t i) const { return {x[i], y[i], z[i]}; }
  Vector3d normalAt(std::uint32_t i) const { return {nx[i], ny[i], nz[i]}; }

  template <class Archive>
  void archive(Archive& ar) {
    ar(nodes, x, y, z, nx, ny, nz, area, shell_index, families, levels);
  }
};

/// Splits top-down at medians of the widest axis; leaves are full but for the last of a subtree. An empty
/// shell gives a tree without nodes.
PointSphereTree makeTree(const Pointshell& shell);

}  // namespace abstand::shell
