// Binary tree of boxes over blocks of neighbouring points, for nearest-point and half-space queries.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::shell {

/// Indices of the points in Morton order: neighbours in space are near each other.
std::vector<std::uint32_t> mortonOrder(const std::vector<Vector3f>& points);

/// Points in Morton order, in blocks of kBlock, under a complete binary tree of boxes.
struct BlockTree {
  static constexpr std::size_t kBlock = 16;

  /// The fourth component is unused; it makes each corner one vector register.
  struct Box {
    Eigen::Array4f lower, upper;
    float squaredDistance(const Eigen::Array4f& p) const {
      return (lower - p).max(p - upper).max(0.0f).matrix().squaredNorm();
    }
    /// Smallest u . p over the box; infinite if it is empty. `u` has the fourth component 0.
    float lowest(const Eigen::Array4f& u) const { return (u * lower).min(u * upper).sum(); }
  };
  static Eigen::Array4f corner(const Vector3f& p) { return {p.x(), p.y(), p.z(), 0.0f}; }

  explicit BlockTree(const std::vector<Vector3f>& points);

  /// True if there is no point below this node.
  bool empty(std::size_t node) const { return boxes[node].lower[0] > boxes[node].upper[0]; }
  /// Half-open range of positions of a leaf's points.
  std::pair<std::size_t, std::size_t> block(std::size_t leaf) const {
    const std::size_t first = (leaf - leaves) * kBlock;
    return {first, std::min(first + kBlock, order.size())};
  }

  std::size_t leaves{1};  ///< a power of two; node n has the children 2n and 2n + 1, the root is 1
  std::vector<Box> boxes;
  std::vector<std::uint32_t> order;  ///< position -> index of the point
  std::vector<float> x, y, z;        ///< padded to whole blocks
};

/// Nearest-point queries on a fixed set of points.
class NearestOfPoints {
 public:
  NearestOfPoints() : NearestOfPoints(std::vector<Vector3f>{}) {}
  explicit NearestOfPoints(const std::vector<Vector3f>& points) : tree_(points) {}
  bool empty() const { return tree_.order.empty(); }
  /// Distance from p to the nearest point, and its index. If no point is nearer than `limit` (m): `limit`,
  /// and `index` is unchanged.
  double distance(const Vector3d& p, std::uint32_t& index, double limit = kInfinity) const;

 private:
  void visit(std::size_t node, const Eigen::Array4f& p, float& best, std::uint32_t& index) const;
  BlockTree tree_;
};

/// Half-space queries on a fixed set of points.
class PointsBelow {
 public:
  explicit PointsBelow(const std::vector<Vector3f>& points) : tree_(points) {}
  /// Indices of the points in Morton order.
  const std::vector<std::uint32_t>& order() const { return tree_.order; }
  /// Smallest u . p over all points; infinite if there are none.
  float lowest(const Vector3f& u) const;
  /// Appends the indices of the points with u . p < level; stops after the block in which their number
  /// exceeds `max_count`.
  void find(const Vector3f& u, float level, std::size_t max_count, std::vector<std::uint32_t>& out) const;

 private:
  BlockTree tree_;
};

}  // namespace abstand::shell
