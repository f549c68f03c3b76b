// Morton order, nearest points, points in half-spaces.
#include "core/shell/pointshell_tree.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace abstand::shell {
namespace {

using Lane = Eigen::Array<float, BlockTree::kBlock, 1>;

/// Inserts two zero bits after each of the low 21 bits.
std::uint64_t spreadBits(std::uint64_t v) {
  v &= 0x1fffff;
  v = (v | v << 32) & 0x1f00000000ffffULL;
  v = (v | v << 16) & 0x1f0000ff0000ffULL;
  v = (v | v << 8) & 0x100f00f00f00f00fULL;
  v = (v | v << 4) & 0x10c30c30c30c30c3ULL;
  return (v | v << 2) & 0x1249249249249249ULL;
}

}  // namespace

std::vector<std::uint32_t> mortonOrder(const std::vector<Vector3f>& points) {
  Vector3f lower = Vector3f::Constant(std::numeric_limits<float>::infinity()), upper = -lower;
  for (const Vector3f& p : points) {
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
  const double extent = points.empty() ? 0.0 : static_cast<double>((upper - lower).maxCoeff());
  const double scale = extent > 0.0 ? 2097151.0 / extent : 0.0;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    std::uint64_t code = 0;
    for (int axis = 0; axis < 3; ++axis) {
      code |= spreadBits(static_cast<std::uint64_t>((double(points[i][axis]) - lower[axis]) * scale)) << axis;
    }
    keys[i] = {code, i};
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order(points.size());
  for (std::size_t i = 0; i < keys.size(); ++i) order[i] = keys[i].second;
  return order;
}

BlockTree::BlockTree(const std::vector<Vector3f>& points) : order(mortonOrder(points)) {
  const std::size_t blocks = (points.size() + kBlock - 1) / kBlock;
  leaves = std::bit_ceil(std::max<std::size_t>(blocks, 1));
  constexpr float kFar = std::numeric_limits<float>::infinity();
  boxes.assign(2 * leaves,
               {Eigen::Array4f(kFar, kFar, kFar, 0.0f), Eigen::Array4f(-kFar, -kFar, -kFar, 0.0f)});
  for (auto* c : {&x, &y, &z}) c->assign(blocks * kBlock, kFar);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Vector3f& p = points[order[i]];
    x[i] = p.x(), y[i] = p.y(), z[i] = p.z();
    Box& box = boxes[leaves + i / kBlock];
    box.lower = box.lower.min(corner(p));
    box.upper = box.upper.max(corner(p));
  }
  for (std::size_t n = leaves - 1; n > 0; --n) {
    boxes[n].lower = boxes[2 * n].lower.min(boxes[2 * n + 1].lower);
    boxes[n].upper = boxes[2 * n].upper.max(boxes[2 * n + 1].upper);
  }
}

double NearestOfPoints::distance(const Vector3d& p, std::uint32_t& index, double limit) const {
  const Eigen::Array4f q = BlockTree::corner(p.cast<float>());
  constexpr std::uint32_t kNoIndex = 0xffffffffu;
  float best = static_cast<float>(limit * limit);
  std::uint32_t at = kNoIndex;
  if (tree_.boxes[1].squaredDistance(q) < best) visit(1, q, best, at);
  if (at == kNoIndex) return limit;
  index = tree_.order[at];
  return (Vector3d(tree_.x[at], tree_.y[at], tree_.z[at]) - p).norm();
}

void NearestOfPoints::visit(std::size_t node, const Eigen::Array4f& p, float& best,
                            std::uint32_t& index) const {
  if (node >= tree_.leaves) {
    const std::size_t first = (node - tree_.leaves) * BlockTree::kBlock;
    const auto at = [first](const std::vector<float>& v) { return Eigen::Map<const Lane>(v.data() + first); };
    // Padding points are infinitely far away.
    const Lane d2 =
        (at(tree_.x) - p[0]).square() + (at(tree_.y) - p[1]).square() + (at(tree_.z) - p[2]).square();
    if (!(d2.minCoeff() < best)) return;
    for (std::size_t i = 0; i < BlockTree::kBlock; ++i) {
      if (d2[Eigen::Index(i)] < best)
        best = d2[Eigen::Index(i)], index = static_cast<std::uint32_t>(first + i);
    }
    return;
  }
  std::size_t near = 2 * node, far = near + 1;
  float near_d2 = tree_.boxes[near].squaredDistance(p), far_d2 = tree_.boxes[far].squaredDistance(p);
  if (far_d2 < near_d2) std::swap(near, far), std::swap(near_d2, far_d2);
  if (near_d2 < best) visit(near, p, best, index);
  if (far_d2 < best) visit(far, p, best, index);
}

float PointsBelow::lowest(const Vector3f& u) const {
  if (tree_.order.empty()) return std::numeric_limits<float>::infinity();
  const Eigen::Array4f direction = BlockTree::corner(u);
  float best = std::numeric_limits<float>::infinity();
  std::array<std::size_t, 64> stack;
  int top = 0;
  stack[top++] = 1;
  while (top > 0) {
    const std::size_t node = stack[--top];
    if (tree_.empty(node) || tree_.boxes[node].lowest(direction) >= best) continue;
    if (node >= tree_.leaves) {
      const auto [first, last] = tree_.block(node);
      for (std::size_t i = first; i < last; ++i) {
        best = std::min(best, u.x() * tree_.x[i] + u.y() * tree_.y[i] + u.z() * tree_.z[i]);
      }
      continue;
    }
    // The child with the smaller bound is visited first.
    const bool right = !tree_.empty(2 * node + 1) &&
                       tree_.boxes[2 * node + 1].lowest(direction) < tree_.boxes[2 * node].lowest(direction);
    stack[top++] = 2 * node + (right ? 0 : 1);
    stack[top++] = 2 * node + (right ? 1 : 0);
  }
  return best;
}

void PointsBelow::find(const Vector3f& u, float level, std::size_t max_count,
                       std::vector<std::uint32_t>& out) const {
  const Eigen::Array4f direction = BlockTree::corner(u);
  std::array<std::size_t, 64> stack;
  int top = 0;
  stack[top++] = 1;
  while (top > 0 && out.size() <= max_count) {
    const std::size_t node = stack[--top];
    if (tree_.empty(node) || tree_.boxes[node].lowest(direction) >= level) continue;
    if (node < tree_.leaves) {
      stack[top++] = 2 * node + 1;
      stack[top++] = 2 * node;
      continue;
    }
    const auto [first, last] = tree_.block(node);
    for (std::size_t i = first; i < last; ++i) {
      if (u.x() * tree_.x[i] + u.y() * tree_.y[i] + u.z() * tree_.z[i] < level) out.push_back(tree_.order[i]);
    }
  }
}

}  // namespace abstand::shell
