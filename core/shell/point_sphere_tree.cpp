// Point-sphere tree: balanced splits, breadth-first nodes, padded leaves.
#include "core/shell/point_sphere_tree.hpp"

#include <algorithm>
#include <numeric>

namespace abstand::shell {
namespace {

constexpr std::size_t kLeaf = PointSphereTree::kLeafPoints;
constexpr std::size_t kFan = PointSphereTree::kFanout;

struct Range {
  std::size_t begin, end;
  std::size_t size() const { return end - begin; }
  std::size_t leaves() const { return (size() + kLeaf - 1) / kLeaf; }
};

class Builder {
 public:
  explicit Builder(const Pointshell& shell) : shell_(shell), order_(shell.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
  }

  PointSphereTree build() {
    if (shell_.size() == 0) return std::move(tree_);
    std::vector<Range> ranges{{0, shell_.size()}};
    std::vector<int> depth{1};
    for (std::size_t n = 0; n < ranges.size(); ++n) {
      const Range range = ranges[n];
      tree_.levels = std::max(tree_.levels, depth[n]);
      PointSphereTree::Node node = sphereOf(range);
      if (range.leaves() > 1) {
        const std::size_t first = ranges.size();
        split(range, childCount(range.leaves()), ranges);
        depth.resize(ranges.size(), depth[n] + 1);
        node.first_child = static_cast<std::uint32_t>(first);
        node.children = static_cast<std::uint16_t>(ranges.size() - first);
      } else {
        node.points = static_cast<std::uint16_t>(range.size());
      }
      tree_.nodes.push_back(node);
    }
    storePoints(ranges);
    storeFamilies();
    return std::move(tree_);
  }

 private:
  /// The fewest children that the tree's height allows, so that the nodes above the leaves are full.
  static std::size_t childCount(std::size_t leaves) {
    std::size_t capacity = 1;
    while (capacity * kFan < leaves) capacity *= kFan;
    return (leaves + capacity - 1) / capacity;
  }

  /// Appends `parts` compact parts of the range with nearly equal numbers of leaves.
  void split(const Range& range, std::size_t parts, std::vector<Range>& out) {
    if (parts == 1) {
      out.push_back(range);
      return;
    }
    const std::size_t left_parts = parts / 2;
    const std::size_t left_leaves = range.leaves() * left_parts / parts;
    const std::size_t middle = range.begin + left_leaves * kLeaf;
    geometry::Bounds box;
    for (std::size_t i = range.begin; i < range.end; ++i) box.add(shell_.point(order_[i]));
    int axis = 0;
    box.extent().maxCoeff(&axis);
    const std::vector<float>& key = axis == 0 ? shell_.x : axis == 1 ? shell_.y : shell_.z;
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(range.begin), at(middle), at(range.end), [&](std::uint32_t l, std::uint32_t r) {
      return key[l] < key[r] || (key[l] == key[r] && l < r);
    });
    split({range.begin, middle}, left_parts, out);
    split({middle, range.end}, parts - left_parts, out);
  }

  PointSphereTree::Node sphereOf(const Range& range) {
    scratch_.clear();
    for (std::size_t i = range.begin; i < range.end; ++i) scratch_.push_back(shell_.point(order_[i]));
    const Vector3f centre = geometry::minimalSphere(scratch_).centre.cast<float>();
    double radius2 = 0.0;
    for (const Vector3d& p : scratch_) radius2 = std::max(radius2, (p - centre.cast<double>()).squaredNorm());
    // Two ulps up: one for rounding in double, one for the conversion to float.
    float radius = static_cast<float>(std::sqrt(radius2));
    for (int i = 0; i < 2; ++i) radius = std::nextafter(radius, std::numeric_limits<float>::infinity());
    return {centre.x(), centre.y(), centre.z(), radius, 0, 0, 0, 0};
  }

  void storePoints(const std::vector<Range>& ranges) {
    std::vector<std::size_t> leaves;
    for (std::size_t n = 0; n < ranges.size(); ++n) {
      if (tree_.nodes[n].children == 0) leaves.push_back(n);
    }
    std::sort(leaves.begin(), leaves.end(),
              [&](std::size_t l, std::size_t r) { return ranges[l].begin < ranges[r].begin; });
    for (const std::size_t n : leaves) {
      tree_.nodes[n].first_point = static_cast<std::uint32_t>(tree_.x.size());
      for (std::size_t i = ranges[n].begin; i < ranges[n].end; ++i) store(order_[i], shell_.area[order_[i]]);
      while (tree_.x.size() % PointSphereTree::kLane != 0) store(order_[ranges[n].end - 1], 0.0f);
    }
    // Children follow their parents, so in reverse order their first points are known.
    for (std::size_t n = ranges.size(); n-- > 0;) {
      PointSphereTree::Node& node = tree_.nodes[n];
      if (node.children > 0) node.first_point = tree_.nodes[node.first_child].first_point;
    }
  }

  void storeFamilies() {
    std::vector<std::uint32_t> family(tree_.nodes.size(), 0);
    std::uint32_t families = 0;
    for (std::size_t n = 0; n < tree_.nodes.size(); ++n)
      if (tree_.nodes[n].children > 0) family[n] = families++;
    const auto add = [&](std::uint32_t first, std::size_t count) {
      PointSphereTree::Family f{};
      for (std::size_t c = 0; c < kFan; ++c) {
        const std::uint32_t n = first + static_cast<std::uint32_t>(std::min(c, count - 1));
        const PointSphereTree::Node& node = tree_.nodes[n];
        f.cx[c] = node.cx;
        f.cy[c] = node.cy;
        f.cz[c] = node.cz;
        f.radius[c] = c < count ? node.radius : -std::numeric_limits<float>::infinity();
        f.child[c] = node.children > 0
                         ? family[n]
                         : PointSphereTree::kLeafChild + node.first_point / PointSphereTree::kLane;
      }
      tree_.families.push_back(f);
    };
    if (families == 0) add(0, 1);
    for (const PointSphereTree::Node& node : tree_.nodes)
      if (node.children > 0) add(node.first_child, node.children);
  }

  void store(std::uint32_t i, float area) {
    tree_.x.push_back(shell_.x[i]);
    tree_.y.push_back(shell_.y[i]);
    tree_.z.push_back(shell_.z[i]);
    tree_.nx.push_back(shell_.nx[i]);
    tree_.ny.push_back(shell_.ny[i]);
    tree_.nz.push_back(shell_.nz[i]);
    tree_.area.push_back(area);
    tree_.shell_index.push_back(i);
  }

  const Pointshell& shell_;
  std::vector<std::uint32_t> order_;
  std::vector<Vector3d> scratch_;
  PointSphereTree tree_;
};

}  // namespace

PointSphereTree makeTree(const Pointshell& shell) { return Builder(shell).build(); }

}  // namespace abstand::shell
