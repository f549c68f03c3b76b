// Tree of axis-aligned boxes over triangles: nearest point of a mesh.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/triangle_mesh.hpp"
#include "core/math/four.hpp"

namespace abstand::geometry {

/// Which part of a triangle a point lies on. Corner i is the triangle's first (A), second (B) or third (C)
/// corner in the order of TriangleTree::corners; edge i runs from corner i to the next.
enum class Feature : std::uint8_t { kFace, kEdge0, kEdge1, kEdge2, kCorner0, kCorner1, kCorner2 };

/// Bounding volume hierarchy with four children for each node, boxes in float rounded outwards, split by the
/// surface area heuristic; triangles in double, in leaf order ("slots"). Constant after construction. Queries
/// allocate nothing, do not throw, and return the same result for any hint.
class TriangleTree {
 public:
  static constexpr int kWidth = 4;
  static constexpr int kLeafTriangles = 4;
  static constexpr std::uint32_t kNone = 0xffffffffu;

  /// A node's four children. `count` 0: the inner node `index`; else the leaf `index`, of `count` slots.
  /// Unused children have an empty box and index kNone.
  struct alignas(16) Node {
    float lower[3][kWidth];
    float upper[3][kWidth];
    std::uint32_t index[kWidth];
    std::uint32_t count[kWidth];
  };
  struct Nearest {
    Vector3d point;   ///< on the triangle
    double distance;  ///< |p - point|
    std::uint32_t slot;
    Feature feature;
  };

  TriangleTree() = default;
  /// Triangles must have positive area; at least one.
  explicit TriangleTree(const TriangleMesh& mesh);

  /// Nearest point of all triangles (p nearer than 1e18 m); the smallest slot among equally near ones.
  /// `hint`: slot of an earlier result nearby, or kNone. Exact up to rounding in double.
  Nearest closest(const Vector3d& p, std::uint32_t hint = kNone) const;
  /// Nearest point of one triangle.
  Nearest closestOn(std::uint32_t slot, const Vector3d& p) const;

  std::size_t size() const { return triangles_.size(); }
  /// Index of a slot's triangle in the mesh.
  std::uint32_t triangle(std::uint32_t slot) const { return triangles_[slot].id; }
  /// The corners A, B, C of a slot: corner (i + rotation) % 3 of the mesh's triangle.
  int rotation(std::uint32_t slot) const { return triangles_[slot].rotation; }
  const Vector3d& normal(std::uint32_t slot) const { return triangles_[slot].n; }
  const std::vector<Node>& nodes() const { return nodes_; }
  /// First slot of a leaf; its other slots follow.
  std::uint32_t firstSlot(std::uint32_t leaf) const { return leaves_[leaf].first; }
  /// The boxes of the nodes are relative to this point.
  const Vector3d& origin() const { return origin_; }

  /// Calls fn(slot) for every triangle of a leaf whose box overlaps `box`.
  template <class Fn>
  void forOverlapping(const Bounds& box, Fn&& fn) const;

  template <class Archive>
  void archive(Archive& ar) {
    ar(origin_, scale_, nodes_, triangles_, leaves_);
  }

 private:
  /// A triangle in its own frame: A at the origin, the longest edge AB along ex, C = (cx, cy) with cy > 0.
  struct Triangle {
    using ArchivedAsBytes = void;
    Vector3d a, ex, ey, n;  ///< a relative to origin_
    double bx, cx, cy;
    std::uint32_t id;
    std::uint32_t rotation;
  };
  struct Local;
  /// Triangles of a leaf as a structure of arrays in float, to select those to test in double. Unused lanes
  /// repeat the last triangle.
  struct Leaf {
    using ArchivedAsBytes = void;
    Four a[3], ex[3], ey[3], n[3];
    Four bx, cx, cy, ux;    ///< ux = bx - cx
    Four per_ac2, per_bc2;  ///< 1 / squared lengths of edges AC and BC
    std::uint32_t first, count;
  };

  static Local closestLocal(const Triangle& t, const Vector3d& ap);
  static Four squaredDistances(const Leaf& leaf, const Eigen::Vector3f& q);
  static Four squaredDistances(const Node& node, const Eigen::Vector3f& low, const Eigen::Vector3f& high);
  std::uint32_t descend(const Eigen::Vector3f& q) const;

  Vector3d origin_{Vector3d::Zero()};
  float scale_{0.0f};  ///< largest absolute coordinate of a box
  std::vector<Node> nodes_;
  std::vector<Triangle> triangles_;
  std::vector<Leaf> leaves_;

  friend class TriangleTreeBuilder;
};

template <class Fn>
void TriangleTree::forOverlapping(const Bounds& box, Fn&& fn) const {
  const Eigen::Vector3f lo = (box.lower - origin_).cast<float>();
  const Eigen::Vector3f hi = (box.upper - origin_).cast<float>();
  const float slack = 1e-6f * scale_;
  std::array<std::uint32_t, 256> stack;
  int top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const Node& node = nodes_[stack[--top]];
    for (int c = 0; c < kWidth; ++c) {
      bool apart = false;
      for (int k = 0; k < 3; ++k) {
        apart = apart || node.lower[k][c] > hi[k] + slack || node.upper[k][c] < lo[k] - slack;
      }
      if (apart || node.index[c] == kNone) continue;
      if (node.count[c] == 0) {
        stack[top++] = node.index[c];
      } else {
        const std::uint32_t first = firstSlot(node.index[c]);
        for (std::uint32_t i = 0; i < node.count[c]; ++i) fn(first + i);
      }
    }
  }
}

}  // namespace abstand::geometry
