// Blocks of neighbouring points with their boxes, for nearest-point and half-space questions.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::shell {

/// Indices of the points, neighbours in space beside each other.
std::vector<std::uint32_t> mortonOrder(const std::vector<Vector3f>& points);

/// Points in Morton order, in blocks of kBlock, under a complete binary tree of boxes.
struct BlockTree {
  static constexpr std::size_t kBlock = 16;

  /// The fourth component is not used; it makes one vector register of each corner.
  struct Box {
    Eigen::Array4f lower, upper;
    float squaredDistance(const Eigen::Array4f& p) const {
      return (lower - p).max(p - upper).max(0.0f).matrix().squaredNorm();
    }
    /// Least u . p of the box; infinite when it is empty. `u` with fourth component 0.
    float lowest(const Eigen::Array4f& u) const { return (u * lower).min(u * upper).sum(); }
  };
  static Eigen::Array4f corner(const Vector3f& p) { return {p.x(), p.y(), p.z(), 0.0f}; }

  explicit BlockTree(const std::vector<Vector3f>& points);

  /// No point below this node.
  bool empty(std::size_t node) const { return boxes[node].lower[0] > boxes[node].upper[0]; }
  /// Positions in the blocks of a leaf's points: from the first to before the second.
  std::pair<std::size_t, std::size_t> block(std::size_t leaf) const {
    const std::size_t first = (leaf - leaves) * kBlock;
    return {first, std::min(first + kBlock, order.size())};
  }

  std::size_t leaves{1};  ///< a power of two; node n has the children 2n and 2n + 1, the root is 1
  std::vector<Box> boxes;
  std::vector<std::uint32_t> order;  ///< position in the blocks -> index of the point
  std::vector<float> x, y, z;        ///< padded to whole blocks
};

/// Nearest of a fixed set of points.
class NearestOfPoints {
 public:
  NearestOfPoints() : NearestOfPoints(std::vector<Vector3f>{}) {}
  explicit NearestOfPoints(const std::vector<Vector3f>& points) : tree_(points) {}
  bool empty() const { return tree_.order.empty(); }
  /// Distance from p to the nearest point, and its index; `limit` and no index when none is nearer than
  /// `limit` (m).
  double distance(const Vector3d& p, std::uint32_t& index, double limit = kInfinity) const;

 private:
  void visit(std::size_t node, const Eigen::Array4f& p, float& best, std::uint32_t& index) const;
  BlockTree tree_;
};

/// Points of a fixed set below planes.
class PointsBelow {
 public:
  explicit PointsBelow(const std::vector<Vector3f>& points) : tree_(points) {}
  /// The points' indices, neighbours in space beside each other.
  const std::vector<std::uint32_t>& order() const { return tree_.order; }
  /// Least u . p over all points; infinite when there are none.
  float lowest(const Vector3f& u) const;
  /// Appends the indices of the points with u . p < level; stops once there are more than `most`, in blocks.
  void find(const Vector3f& u, float level, std::size_t most, std::vector<std::uint32_t>& out) const;

 private:
  BlockTree tree_;
};

}  // namespace abstand::shell
