// Blocks of neighbouring points: Morton order, farthest and nearest points.
#include "core/haptic/pointshell_tree.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace abstand {
namespace {

/// Spreads the low 21 bits so that two zero bits follow each.
std::uint64_t spread(std::uint64_t v) {
  v &= 0x1fffff;
  v = (v | v << 32) & 0x1f00000000ffffULL;
  v = (v | v << 16) & 0x1f0000ff0000ffULL;
  v = (v | v << 8) & 0x100f00f00f00f00fULL;
  v = (v | v << 4) & 0x10c30c30c30c30c3ULL;
  return (v | v << 2) & 0x1249249249249249ULL;
}

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
      code |= spread(static_cast<std::uint64_t>((double(points[i][axis]) - lower[axis]) * scale)) << axis;
    }
    keys[i] = {code, i};
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order(points.size());
  for (std::size_t i = 0; i < keys.size(); ++i) order[i] = keys[i].second;
  return order;
}

}  // namespace

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

double NearestPoint::distance(const Vector3d& p, std::uint32_t& index, double limit) const {
  const Eigen::Array4f q = BlockTree::corner(p.cast<float>());
  constexpr std::uint32_t kNone = 0xffffffffu;
  float best = static_cast<float>(limit * limit);
  std::uint32_t at = kNone;
  visit(1, q, best, at);
  if (at == kNone) return limit;
  index = tree_.order[at];
  return (Vector3d(tree_.x[at], tree_.y[at], tree_.z[at]) - p).norm();
}

void NearestPoint::visit(std::size_t node, const Eigen::Array4f& p, float& best, std::uint32_t& index) const {
  if (node >= tree_.leaves) {
    const std::size_t first = (node - tree_.leaves) * BlockTree::kBlock;
    const std::size_t last = std::min(first + BlockTree::kBlock, tree_.order.size());
    for (std::size_t i = first; i < last; ++i) {
      const float dx = tree_.x[i] - p[0], dy = tree_.y[i] - p[1], dz = tree_.z[i] - p[2];
      const float d2 = dx * dx + dy * dy + dz * dz;
      if (d2 < best) best = d2, index = static_cast<std::uint32_t>(i);
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
    // The lower child is looked at first.
    const bool right = !tree_.empty(2 * node + 1) &&
                       tree_.boxes[2 * node + 1].lowest(direction) < tree_.boxes[2 * node].lowest(direction);
    stack[top++] = 2 * node + (right ? 0 : 1);
    stack[top++] = 2 * node + (right ? 1 : 0);
  }
  return best;
}

void PointsBelow::find(const Vector3f& u, float level, std::size_t most,
                       std::vector<std::uint32_t>& out) const {
  const Eigen::Array4f direction = BlockTree::corner(u);
  std::array<std::size_t, 64> stack;
  int top = 0;
  stack[top++] = 1;
  while (top > 0 && out.size() <= most) {
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

SampleCover::SampleCover(const std::vector<Vector3f>& points, const std::vector<Vector3f>& normals,
                         const std::vector<float>& weights)
    : tree_(points) {
  const std::size_t n = tree_.x.size();
  for (auto* c : {&nx_, &ny_, &nz_}) c->assign(n, 0.0f);
  weight_.assign(n, 1.0f);
  for (std::size_t i = 0; i < tree_.order.size(); ++i) {
    const Vector3f& m = normals[tree_.order[i]];
    nx_[i] = m.x(), ny_[i] = m.y(), nz_[i] = m.z();
    weight_[i] = weights[tree_.order[i]];
  }
  d2_.resize(n);
  nearest_.resize(n);
  node_d2_.resize(2 * tree_.leaves);
  reset();
}

void SampleCover::reset() {
  constexpr float kFar = std::numeric_limits<float>::max();
  // Padding and empty blocks count as covered.
  for (std::size_t i = 0; i < d2_.size(); ++i) d2_[i] = i < tree_.order.size() ? kFar : -1.0f;
  std::fill(nearest_.begin(), nearest_.end(), 0u);
  for (std::size_t leaf = 0; leaf < tree_.leaves; ++leaf) {
    node_d2_[tree_.leaves + leaf] = leaf * BlockTree::kBlock < tree_.order.size() ? kFar : -1.0f;
  }
  for (std::size_t n = tree_.leaves - 1; n > 0; --n)
    node_d2_[n] = std::max(node_d2_[2 * n], node_d2_[2 * n + 1]);
}

void SampleCover::add(std::uint32_t centre, const Vector3f& p, const Vector3f& n) {
  visit(1, {centre, BlockTree::corner(p), n});
}

void SampleCover::visit(std::size_t node, const Centre& c) {
  if (tree_.boxes[node].squaredDistance(c.p) >= node_d2_[node]) return;
  if (node < tree_.leaves) {
    visit(2 * node, c);
    visit(2 * node + 1, c);
    node_d2_[node] = std::max(node_d2_[2 * node], node_d2_[2 * node + 1]);
    return;
  }
  const std::size_t first = (node - tree_.leaves) * BlockTree::kBlock;
  using Lane = Eigen::Array<float, BlockTree::kBlock, 1>;
  const auto at = [first](const std::vector<float>& v) { return Eigen::Map<const Lane>(v.data() + first); };
  Eigen::Map<Lane> best(d2_.data() + first);
  const Lane d2 = at(weight_) * ((at(tree_.x) - c.p[0]).square() + (at(tree_.y) - c.p[1]).square() +
                                 (at(tree_.z) - c.p[2]).square() + (at(nx_) - c.n[0]).square() +
                                 (at(ny_) - c.n[1]).square() + (at(nz_) - c.n[2]).square());
  if (!(d2 < best).any()) return;
  for (std::size_t i = 0; i < BlockTree::kBlock; ++i) {
    if (d2[Eigen::Index(i)] < best[Eigen::Index(i)]) nearest_[first + i] = c.id;
  }
  best = best.min(d2);
  const float largest = best.maxCoeff();
  node_d2_[node] = largest;
}

std::uint32_t SampleCover::farthest(float& squared_distance) const {
  std::size_t node = 1;
  while (node < tree_.leaves) node = node_d2_[2 * node] >= node_d2_[2 * node + 1] ? 2 * node : 2 * node + 1;
  squared_distance = node_d2_[node];
  const std::size_t first = (node - tree_.leaves) * BlockTree::kBlock;
  std::size_t at = first;
  for (std::size_t i = first; i < first + BlockTree::kBlock; ++i) {
    if (d2_[i] > d2_[at]) at = i;
  }
  return tree_.order[at];
}

std::vector<std::uint32_t> SampleCover::nearest() const {
  std::vector<std::uint32_t> out(tree_.order.size());
  for (std::size_t i = 0; i < out.size(); ++i) out[tree_.order[i]] = nearest_[i];
  return out;
}

}  // namespace abstand
