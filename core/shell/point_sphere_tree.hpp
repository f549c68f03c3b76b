// Point-sphere tree: hierarchy of minimal enclosing spheres over the points of a pointshell.
#pragma once

#include "core/geometry/enclosing_sphere.hpp"
#include "core/shell/pointshell.hpp"

namespace abstand::shell {

/// At most kFanout children for each node and kLeafPoints points for each leaf. The points are copied in leaf
/// order (structure of arrays; each leaf is padded to a multiple of kLane with copies of its last point of
/// area 0), so that a leaf is contiguous in memory. Constant after construction.
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
    std::uint16_t points;       ///< real points of a leaf, without padding; 0 for an inner node
  };
  /// Spheres of a node's children as a structure of arrays, for SIMD. Unused entries have the radius
  /// -infinity, so they are never near.
  struct Family {
    float cx[kFanout], cy[kFanout], cz[kFanout], radius[kFanout];
    std::uint32_t child[kFanout];  ///< index of the child's family; or kLeafChild + first point / kLane
  };
  static constexpr std::uint32_t kLeafChild = 0x80000000u;

  std::vector<Node> nodes;                       ///< nodes[0] is the root; breadth-first
  std::vector<float> x, y, z, nx, ny, nz, area;  ///< leaf order, padded
  std::vector<std::uint32_t> shell_index;        ///< leaf order -> index in the Pointshell
  std::vector<Family>
      families;  ///< of the inner nodes in order; families[0] has the root's children, or the root alone
  int levels{0};

  /// Position of a point in leaf order.
  Vector3d at(std::uint32_t i) const { return {x[i], y[i], z[i]}; }
  Vector3d normalAt(std::uint32_t i) const { return {nx[i], ny[i], nz[i]}; }

  template <class Archive>
  void archive(Archive& ar) {
    ar(nodes, x, y, z, nx, ny, nz, area, shell_index, families, levels);
  }
};

/// Top-down median splits along the widest axis; all leaves are full except the last of a subtree. An empty
/// shell gives a tree without nodes.
PointSphereTree makeTree(const Pointshell& shell);

}  // namespace abstand::shell
