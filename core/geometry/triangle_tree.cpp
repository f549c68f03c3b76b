// Bounding volume hierarchy of axis-aligned boxes over triangles: nearest point of a mesh.
#include "core/geometry/triangle_tree.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "core/base/error.hpp"

namespace abstand::geometry {
namespace {

constexpr float kFloatInfinity = std::numeric_limits<float>::infinity();
// A box's squared distance in float may be too large by a few rounding errors; pruning allows for them.
constexpr float kPruneFactor = 1.0f + 8e-6f;
// Rounding error of a query point in float, relative to its size, and of the boxes' corners.
constexpr float kFloatSlack = 3e-7f;
// Error bound of a float distance to a triangle, relative to the sizes of query and tree: about ten rounding
// errors and a reserve.
constexpr float kLeafSlack = 4e-6f;
// The tree's depth is limited by median splits; a level needs at most 4 stack entries.
constexpr int kStack = 256;
constexpr int kBins = 16;

float roundDown(double v) { return std::nextafter(static_cast<float>(v), -kFloatInfinity); }
float roundUp(double v) { return std::nextafter(static_cast<float>(v), kFloatInfinity); }

double halfArea(const Bounds& box) {
  const Vector3d e = box.extent();
  return e.x() * e.y() + e.y() * e.z() + e.z() * e.x();
}

}  // namespace

struct TriangleTree::Local {
  double x, y;  ///< nearest point in the triangle's frame
  double d2;
  Feature feature;
};

/// Builds the nodes depth-first. Splits depend on centroids alone, so the tree is the same on every run.
class TriangleTreeBuilder {
 public:
  TriangleTreeBuilder(const TriangleMesh& mesh, TriangleTree& tree) : mesh_(mesh), tree_(tree) {
    const std::size_t n = mesh.triangles.size();
    boxes_.resize(n);
    centres_.resize(n);
    order_.resize(n);
    std::iota(order_.begin(), order_.end(), 0u);
    Bounds all;
    for (std::size_t t = 0; t < n; ++t) {
      for (int i = 0; i < 3; ++i) boxes_[t].add(mesh.corner(t, i));
      all.add(boxes_[t].lower);
      all.add(boxes_[t].upper);
      centres_[t] = boxes_[t].centre();
    }
    tree_.origin_ = all.centre();
    tree_.scale_ = roundUp(0.5 * all.extent().maxCoeff());
    tree_.nodes_.reserve(n / 2 + 1);
    build(0, static_cast<std::uint32_t>(n), 0);
    tree_.triangles_.reserve(n);
    for (const std::uint32_t t : order_) addTriangle(t);
    for (TriangleTree::Leaf& leaf : tree_.leaves_) fillLeaf(leaf);
  }

 private:
  struct Range {
    std::uint32_t begin, end;
    std::uint32_t size() const { return end - begin; }
  };

  Bounds boxOf(Range r) const {
    Bounds box;
    for (std::uint32_t i = r.begin; i < r.end; ++i) {
      box.add(boxes_[order_[i]].lower);
      box.add(boxes_[order_[i]].upper);
    }
    return box;
  }

  // Splits by the surface area heuristic over bins along the longest axis of the centroids; at the median
  // deep in an unbalanced tree, or if the bins do not separate anything.
  std::uint32_t split(Range r, int depth) {
    Bounds centroids;
    for (std::uint32_t i = r.begin; i < r.end; ++i) centroids.add(centres_[order_[i]]);
    int axis = 0;
    const double width = centroids.extent().maxCoeff(&axis);
    const auto begin = order_.begin();
    constexpr int kMedianDepth = 20;
    if (width > 0.0 && depth < kMedianDepth) {
      const double to_bin = kBins / width;
      const auto binOf = [&](std::uint32_t t) {
        return std::min(kBins - 1, static_cast<int>((centres_[t][axis] - centroids.lower[axis]) * to_bin));
      };
      std::array<Bounds, kBins> box;
      std::array<std::uint32_t, kBins> count{};
      for (std::uint32_t i = r.begin; i < r.end; ++i) {
        const int b = binOf(order_[i]);
        ++count[b];
        box[b].add(boxes_[order_[i]].lower);
        box[b].add(boxes_[order_[i]].upper);
      }
      std::array<double, kBins> cost{};
      Bounds left, right;
      std::uint32_t left_count = 0, right_count = 0;
      for (int b = 0; b + 1 < kBins; ++b) {
        left_count += count[b];
        if (count[b] > 0) left.add(box[b].lower), left.add(box[b].upper);
        cost[b] = left_count > 0 ? left_count * halfArea(left) : kInfinity;
      }
      int best = -1;
      double best_cost = kInfinity;
      for (int b = kBins - 2; b >= 0; --b) {
        right_count += count[b + 1];
        if (count[b + 1] > 0) right.add(box[b + 1].lower), right.add(box[b + 1].upper);
        const double c = right_count > 0 ? cost[b] + right_count * halfArea(right) : kInfinity;
        if (c < best_cost) best_cost = c, best = b;
      }
      if (best >= 0) {
        const auto middle =
            std::partition(begin + r.begin, begin + r.end, [&](std::uint32_t t) { return binOf(t) <= best; });
        return static_cast<std::uint32_t>(middle - begin);
      }
    }
    const std::uint32_t middle = r.begin + r.size() / 2;
    std::nth_element(begin + r.begin, begin + middle, begin + r.end, [&](std::uint32_t s, std::uint32_t t) {
      return centres_[s][axis] != centres_[t][axis] ? centres_[s][axis] < centres_[t][axis] : s < t;
    });
    return middle;
  }

  std::uint32_t build(std::uint32_t begin, std::uint32_t end, int depth) {
    std::array<Range, TriangleTree::kWidth> parts{Range{begin, end}};
    int n = 1;
    while (n < TriangleTree::kWidth) {
      int largest = 0;
      for (int i = 1; i < n; ++i) {
        if (parts[i].size() > parts[largest].size()) largest = i;
      }
      if (parts[largest].size() <= TriangleTree::kLeafTriangles) break;
      const std::uint32_t middle = split(parts[largest], depth);
      parts[n++] = {middle, parts[largest].end};
      parts[largest].end = middle;
    }
    const std::uint32_t index = static_cast<std::uint32_t>(tree_.nodes_.size());
    tree_.nodes_.emplace_back();
    for (int c = 0; c < TriangleTree::kWidth; ++c) {
      const Bounds box = c < n ? boxOf(parts[c]) : Bounds{};
      for (int k = 0; k < 3; ++k) {
        tree_.nodes_[index].lower[k][c] = c < n ? roundDown(box.lower[k] - tree_.origin_[k]) : kFloatInfinity;
        tree_.nodes_[index].upper[k][c] = c < n ? roundUp(box.upper[k] - tree_.origin_[k]) : -kFloatInfinity;
      }
      tree_.nodes_[index].index[c] = TriangleTree::kNone;
      tree_.nodes_[index].count[c] = 0;
    }
    for (int c = 0; c < n; ++c) {
      const bool leaf = parts[c].size() <= TriangleTree::kLeafTriangles;
      const std::uint32_t child = leaf ? addLeaf(parts[c]) : build(parts[c].begin, parts[c].end, depth + 1);
      tree_.nodes_[index].index[c] = child;
      tree_.nodes_[index].count[c] = leaf ? parts[c].size() : 0;
    }
    return index;
  }

  std::uint32_t addLeaf(Range r) {
    tree_.leaves_.emplace_back();
    tree_.leaves_.back().first = r.begin;
    tree_.leaves_.back().count = r.size();
    return static_cast<std::uint32_t>(tree_.leaves_.size() - 1);
  }

  void fillLeaf(TriangleTree::Leaf& leaf) const {
    for (std::uint32_t lane = 0; lane < TriangleTree::kLeafTriangles; ++lane) {
      const TriangleTree::Triangle& t = tree_.triangles_[leaf.first + std::min(lane, leaf.count - 1)];
      for (int k = 0; k < 3; ++k) {
        leaf.a[k][lane] = static_cast<float>(t.a[k]);
        leaf.ex[k][lane] = static_cast<float>(t.ex[k]);
        leaf.ey[k][lane] = static_cast<float>(t.ey[k]);
        leaf.n[k][lane] = static_cast<float>(t.n[k]);
      }
      const double ux = t.bx - t.cx;
      leaf.bx[lane] = static_cast<float>(t.bx);
      leaf.cx[lane] = static_cast<float>(t.cx);
      leaf.cy[lane] = static_cast<float>(t.cy);
      leaf.ux[lane] = static_cast<float>(ux);
      leaf.per_ac2[lane] = static_cast<float>(1.0 / (t.cx * t.cx + t.cy * t.cy));
      leaf.per_bc2[lane] = static_cast<float>(1.0 / (ux * ux + t.cy * t.cy));
    }
  }

  void addTriangle(std::uint32_t id) {
    std::uint32_t rotation = 0;
    double longest = -1.0;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const double l = (mesh_.corner(id, (i + 1) % 3) - mesh_.corner(id, i)).squaredNorm();
      if (l > longest) longest = l, rotation = i;
    }
    const Vector3d a = mesh_.corner(id, rotation);
    const Vector3d ab = mesh_.corner(id, (rotation + 1) % 3) - a;
    const Vector3d ac = mesh_.corner(id, (rotation + 2) % 3) - a;
    TriangleTree::Triangle t;
    t.a = a - tree_.origin_;
    t.bx = ab.norm();
    t.ex = ab / t.bx;
    t.cx = ac.dot(t.ex);
    const Vector3d height = ac - t.cx * t.ex;
    t.cy = height.norm();
    // Second orthogonalisation step: in a sliver `height` is mostly rounding along ex.
    t.ey = height / t.cy;
    t.ey = (t.ey - t.ey.dot(t.ex) * t.ex).normalized();
    t.n = t.ex.cross(t.ey);
    t.id = id;
    t.rotation = rotation;
    tree_.triangles_.push_back(t);
  }

  const TriangleMesh& mesh_;
  TriangleTree& tree_;
  std::vector<Bounds> boxes_;
  std::vector<Vector3d> centres_;
  std::vector<std::uint32_t> order_;
};

TriangleTree::TriangleTree(const TriangleMesh& mesh) {
  ABSTAND_CHECK(!mesh.triangles.empty());
  TriangleTreeBuilder(mesh, *this);
}

// In the triangle's plane the nearest point is the projection, or lies on an edge that has the projection on
// its outer side. Working in the triangle's own frame keeps slivers exact.
TriangleTree::Local TriangleTree::closestLocal(const Triangle& t, const Vector3d& ap) {
  const double x = ap.dot(t.ex), y = ap.dot(t.ey), z = ap.dot(t.n);
  Local best{x, y, z * z, Feature::kFace};
  const double ux = t.bx - t.cx;
  const bool below = y < 0.0;
  const bool right = ux * (y - t.cy) + t.cy * (x - t.cx) > 0.0;
  const bool left = t.cx * y - t.cy * x > 0.0;
  if (!(below || right || left)) return best;
  double plane = kInfinity;
  const auto consider = [&](double qx, double qy, Feature feature) {
    const double d2 = (x - qx) * (x - qx) + (y - qy) * (y - qy);
    if (d2 < plane) plane = d2, best.x = qx, best.y = qy, best.feature = feature;
  };
  if (below) {
    if (x <= 0.0) {
      consider(0.0, 0.0, Feature::kCorner0);
    } else if (x >= t.bx) {
      consider(t.bx, 0.0, Feature::kCorner1);
    } else {
      consider(x, 0.0, Feature::kEdge0);
    }
  }
  if (right) {
    const double s = ((t.bx - x) * ux + y * t.cy) / (ux * ux + t.cy * t.cy);
    if (s <= 0.0) {
      consider(t.bx, 0.0, Feature::kCorner1);
    } else if (s >= 1.0) {
      consider(t.cx, t.cy, Feature::kCorner2);
    } else {
      consider(t.bx - s * ux, s * t.cy, Feature::kEdge1);
    }
  }
  if (left) {
    const double s = (x * t.cx + y * t.cy) / (t.cx * t.cx + t.cy * t.cy);
    if (s <= 0.0) {
      consider(0.0, 0.0, Feature::kCorner0);
    } else if (s >= 1.0) {
      consider(t.cx, t.cy, Feature::kCorner2);
    } else {
      consider(s * t.cx, s * t.cy, Feature::kEdge2);
    }
  }
  best.d2 += plane;
  return best;
}

TriangleTree::Nearest TriangleTree::closestOn(std::uint32_t slot, const Vector3d& p) const {
  const Triangle& t = triangles_[slot];
  const Vector3d ap = p - origin_ - t.a;
  const Local local = closestLocal(t, ap);
  const Vector3d aq = local.x * t.ex + local.y * t.ey;
  return {origin_ + t.a + aq, (ap - aq).norm(), slot, local.feature};
}

// closestLocal() without branches, in float, for all triangles of a leaf.
Four TriangleTree::squaredDistances(const Leaf& leaf, const Eigen::Vector3f& q) {
  const Four px = q.x() - leaf.a[0], py = q.y() - leaf.a[1], pz = q.z() - leaf.a[2];
  const Four x = px * leaf.ex[0] + py * leaf.ex[1] + pz * leaf.ex[2];
  const Four y = px * leaf.ey[0] + py * leaf.ey[1] + pz * leaf.ey[2];
  const Four z = px * leaf.n[0] + py * leaf.n[1] + pz * leaf.n[2];
  const Four zero{}, one = splat(1.0f), from_b = leaf.bx - x;
  const Four ab_x = x - min(max(x, zero), leaf.bx);
  const Four ac = min(max((x * leaf.cx + y * leaf.cy) * leaf.per_ac2, zero), one);
  const Four ac_x = x - ac * leaf.cx, ac_y = y - ac * leaf.cy;
  const Four bc = min(max((from_b * leaf.ux + y * leaf.cy) * leaf.per_bc2, zero), one);
  const Four bc_x = from_b - bc * leaf.ux, bc_y = y - bc * leaf.cy;
  const Four edges = min(min(ab_x * ab_x + y * y, ac_x * ac_x + ac_y * ac_y), bc_x * bc_x + bc_y * bc_y);
  const Four left = leaf.cy * x - leaf.cx * y, right = leaf.cy * from_b - leaf.ux * y;
  const Four within = min(min(y, left), right);
  return z * z + (within >= 0.0f ? zero : edges);
}

Four TriangleTree::squaredDistances(const Node& node, const Eigen::Vector3f& low,
                                    const Eigen::Vector3f& high) {
  static_assert(kWidth == kLeafTriangles);
  Four d2{};
  for (int k = 0; k < 3; ++k) {
    // At most one of the two terms is positive; NaN is kept, so that beyond the range of float no box is
    // near.
    const Four gap = max(Four{}, load(node.lower[k]) - high[k]) + max(Four{}, low[k] - load(node.upper[k]));
    d2 += gap * gap;
  }
  return d2;
}

// A slot near q: descends to the nearest box at each node.
std::uint32_t TriangleTree::descend(const Eigen::Vector3f& q) const {
  std::uint32_t index = 0;
  for (;;) {
    const Node& node = nodes_[index];
    const Four d2 = squaredDistances(node, q, q);
    int nearest = 0;
    for (int c = 1; c < kWidth; ++c) {
      if (d2[c] < d2[nearest]) nearest = c;
    }
    index = node.index[nearest];
    if (node.count[nearest] == 0) continue;
    const Four in_leaf = squaredDistances(leaves_[index], q);
    std::uint32_t lane = 0;
    for (std::uint32_t i = 1; i < node.count[nearest]; ++i) {
      if (in_leaf[i] < in_leaf[lane]) lane = i;
    }
    return leaves_[index].first + lane;
  }
}

TriangleTree::Nearest TriangleTree::closest(const Vector3d& p, std::uint32_t hint) const {
  struct Entry {
    float d2;
    std::uint32_t index, count;
  };
  const Vector3d q = p - origin_;
  const Eigen::Vector3f qf = q.cast<float>();
  const float size = std::max(scale_, qf.cwiseAbs().maxCoeff());
  const Eigen::Vector3f high = qf.array() + kFloatSlack * size, low = qf.array() - kFloatSlack * size;
  const float leaf_slack = kLeafSlack * size;

  std::uint32_t best_slot = hint < triangles_.size() ? hint : descend(qf);
  double best = closestLocal(triangles_[best_slot], q - triangles_[best_slot].a).d2;
  float box_limit, leaf_limit;
  const auto setLimits = [&] {
    const float d = std::sqrt(static_cast<float>(best));
    box_limit = std::min(d * d * kPruneFactor, std::numeric_limits<float>::max());
    leaf_limit = (d + leaf_slack) * (d + leaf_slack) * kPruneFactor;
  };
  setLimits();
  std::array<Entry, kStack> stack;
  int top = 0;
  stack[top++] = {0.0f, 0, 0};
  while (top > 0) {
    const Entry entry = stack[--top];
    if (!(entry.d2 <= box_limit)) continue;
    if (entry.count > 0) {
      const Leaf& leaf = leaves_[entry.index];
      const Four d2 = squaredDistances(leaf, qf);
      for (int near = bits(d2 <= leaf_limit) & ((1 << entry.count) - 1); near != 0; near &= near - 1) {
        const auto i = static_cast<std::uint32_t>(std::countr_zero(static_cast<unsigned>(near)));
        const std::uint32_t slot = leaf.first + i;
        if (!(d2[i] <= leaf_limit) || slot == best_slot) continue;
        const double exact = closestLocal(triangles_[slot], q - triangles_[slot].a).d2;
        if (exact < best || (exact == best && slot < best_slot)) {
          best = exact;
          best_slot = slot;
          setLimits();
        }
      }
      continue;
    }
    // The hint's or descent's triangle already limits the distance, so the order hardly matters: children are
    // not sorted, which avoids unpredictable branches.
    const Node& node = nodes_[entry.index];
    const Four d2 = squaredDistances(node, low, high);
    for (int c = 0; c < kWidth; ++c) {
      stack[top] = {d2[c], node.index[c], node.count[c]};
      top += d2[c] <= box_limit;
    }
  }
  return closestOn(best_slot, p);
}

}  // namespace abstand::geometry
