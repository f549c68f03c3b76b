#include "tracking/joint_guess/point_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tracking/joint_guess/name_guess.hpp"
#include "tracking/joint_guess/rigid_bodies.hpp"

namespace abstand::tracking {
namespace {

/// Standard deviation of a rigid distance, share of the extent: exact poses first, then measured ones.
constexpr double kRigid[]{1e-6, 1e-5, 1e-4, 0.0005, 0.002};
constexpr double kSamePlace = 0.003;
constexpr double kPresent = 0.8;       // share of the frames that a point of the tree has
constexpr std::size_t kMaxPoses = 64;  // for the guess by shape
constexpr std::size_t kBranching = 3;  // joints of a body from which they branch off its middle

struct TreeEdge {
  int a, b;
  double length;
};

/// Connected groups of nodes.
class NodeGroups {
 public:
  explicit NodeGroups(std::size_t n) : group_(n) { std::iota(group_.begin(), group_.end(), 0); }
  int of(int node) {
    while (group_[static_cast<std::size_t>(node)] != node) {
      int& up = group_[static_cast<std::size_t>(node)];
      up = group_[static_cast<std::size_t>(up)];
      node = up;
    }
    return node;
  }
  /// False if they are in one group already.
  bool join(int a, int b) {
    const int from = of(a), to = of(b);
    group_[static_cast<std::size_t>(from)] = to;
    return from != to;
  }

 private:
  std::vector<int> group_;
};

/// Points, then the middles of bodies with three joints and more, as a tree.
class PointTree {
 public:
  PointTree(const PointDistances& distances, double tolerance) : d_{distances} {
    const auto bodies = rigidBodies(d_, tolerance);
    std::vector<std::size_t> bodies_of(d_.size(), 0);
    for (const auto& body : bodies)
      for (const int i : body) ++bodies_of[static_cast<std::size_t>(i)];
    for (const auto& body : bodies) {
      const auto joints = std::count_if(body.begin(), body.end(),
                                        [&](int i) { return bodies_of[static_cast<std::size_t>(i)] > 1; });
      if (body.size() < kBranching || static_cast<std::size_t>(joints) < kBranching) continue;
      middles_.push_back(body);
    }
    const std::size_t n = d_.size() + middles_.size();
    NodeGroups groups(n);
    neighbours_.resize(n);
    const auto join = [&](int a, int b, double length) {
      if (!groups.join(a, b)) return;
      neighbours_[static_cast<std::size_t>(a)].push_back({b, length});
      neighbours_[static_cast<std::size_t>(b)].push_back({a, length});
    };
    for (std::size_t m = 0; m < middles_.size(); ++m)
      for (const int i : middles_[m]) join(static_cast<int>(d_.size() + m), i, fromMiddle(middles_[m], i));
    // Rigid pairs by length, then the others by how little they change.
    std::vector<TreeEdge> edges;
    for (std::size_t a = 0; a < d_.size(); ++a)
      for (std::size_t b = a + 1; b < d_.size(); ++b)
        edges.push_back({static_cast<int>(a), static_cast<int>(b),
                         d_.deviation(a, b) <= tolerance ? d_.mean(a, b)
                                                         : (1.0 + d_.deviation(a, b)) * 1e3 * d_.extent()});
    std::stable_sort(edges.begin(), edges.end(),
                     [](const TreeEdge& x, const TreeEdge& y) { return x.length < y.length; });
    for (const TreeEdge& e : edges)
      join(e.a, e.b, d_.mean(static_cast<std::size_t>(e.a), static_cast<std::size_t>(e.b)));
  }

  std::size_t points() const { return d_.size(); }
  const std::vector<std::vector<int>>& middles() const { return middles_; }

  /// Nodes from the middle of the tree on, each after its parent, and the parents' places in this order.
  void orderFromMiddle(std::vector<int>& order, std::vector<int>& parents) const {
    int root = 0;
    double least = kInfinity;
    for (std::size_t i = 0; i < neighbours_.size(); ++i) {
      if (neighbours_[i].size() < kBranching) continue;
      const double path = orderFrom(static_cast<int>(i), order, parents);
      if (path >= least) continue;
      least = path;
      root = static_cast<int>(i);
    }
    orderFrom(root, order, parents);
  }

 private:
  struct Neighbour {
    int node;
    double length;
  };

  /// Half of the mean distance to the others of a body.
  double fromMiddle(const std::vector<int>& body, int i) const {
    double sum = 0.0;
    for (const int k : body)
      if (k != i) sum += d_.mean(static_cast<std::size_t>(i), static_cast<std::size_t>(k));
    return 0.5 * sum / static_cast<double>(body.size() - 1);
  }

  /// Returns the length of the longest path.
  double orderFrom(int root, std::vector<int>& order, std::vector<int>& parents) const {
    order = {root};
    parents = {-1};
    std::vector<double> paths{0.0};
    for (std::size_t k = 0; k < order.size(); ++k)
      for (const Neighbour& next : neighbours_[static_cast<std::size_t>(order[k])]) {
        if (parents[k] >= 0 && order[static_cast<std::size_t>(parents[k])] == next.node) continue;
        order.push_back(next.node);
        parents.push_back(static_cast<int>(k));
        paths.push_back(paths[k] + next.length);
      }
    return *std::max_element(paths.begin(), paths.end());
  }

  const PointDistances& d_;
  std::vector<std::vector<int>> middles_;
  std::vector<std::vector<Neighbour>> neighbours_;
};

/// Points that enough frames have.
std::vector<int> presentPoints(std::size_t n, std::span<const PointFrame> frames) {
  std::vector<int> points;
  for (std::size_t i = 0; i < n; ++i) {
    const auto present =
        std::count_if(frames.begin(), frames.end(), [&](const PointFrame& f) { return f.p[i].allFinite(); });
    if (static_cast<double>(present) >= kPresent * static_cast<double>(frames.size()))
      points.push_back(static_cast<int>(i));
  }
  return points;
}

/// Without the points that are at the same place as an earlier one.
std::vector<int> distinctPoints(const std::vector<int>& points, std::span<const PointFrame> frames) {
  const PointDistances distances(frames, points);
  std::vector<int> distinct;
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::any_of(kept.begin(), kept.end(),
                    [&](std::size_t k) { return distances.mean(i, k) <= kSamePlace * distances.extent(); }))
      continue;
    kept.push_back(i);
    distinct.push_back(points[i]);
  }
  return distinct;
}

/// The tree as a skeleton for the guess by shape, with some frames that have all its points.
ShapeGuess guessInTree(const PointTree& tree, std::span<const std::string> names, std::span<const int> points,
                       std::span<const PointFrame> frames) {
  std::vector<int> order, parents;
  tree.orderFromMiddle(order, parents);
  std::vector<std::string> node_names;
  for (const int node : order) {
    const auto i = static_cast<std::size_t>(node);
    const int member = i < tree.points() ? node : tree.middles()[i - tree.points()].front();
    node_names.push_back(names[static_cast<std::size_t>(points[static_cast<std::size_t>(member)])]);
  }
  std::vector<PointFrame> poses;
  const std::size_t step = std::max<std::size_t>(1, frames.size() / kMaxPoses);
  for (std::size_t k = 0; k < frames.size(); k += step) {
    const auto at = [&](int i) {
      return frames[k].p[static_cast<std::size_t>(points[static_cast<std::size_t>(i)])];
    };
    PointFrame pose;
    for (const int node : order) {
      const auto i = static_cast<std::size_t>(node);
      Vector3d p = Vector3d::Zero();
      if (i < tree.points()) {
        p = at(node);
      } else {
        const auto& body = tree.middles()[i - tree.points()];
        for (const int member : body) p += at(member) / static_cast<double>(body.size());
      }
      pose.p.push_back(p);
    }
    if (std::all_of(pose.p.begin(), pose.p.end(), [](const Vector3d& p) { return p.allFinite(); }))
      poses.push_back(std::move(pose));
  }
  ShapeGuess guess;
  guess.match.joint.fill(-1);
  guess.reason = "no frame has all points";
  if (poses.empty()) return guess;
  guess = guessByShape({node_names, parents, poses.front().p, poses, true});
  guess.match.mapped = 0;
  for (int& joint : guess.match.joint) {
    if (joint < 0) continue;
    const int node = order[static_cast<std::size_t>(joint)];
    const bool is_point = static_cast<std::size_t>(node) < tree.points();
    joint = is_point ? points[static_cast<std::size_t>(node)] : -1;
    guess.match.mapped += is_point ? 1 : 0;
  }
  return guess;
}

}  // namespace

ShapeGuess guessByMotion(std::span<const std::string> names, std::span<const PointFrame> frames) {
  ShapeGuess none;
  none.match.joint.fill(-1);
  none.reason = "the file has no hierarchy of joints";
  if (frames.empty() || names.size() > kMaxTreePoints) return none;
  const std::vector<int> points = distinctPoints(presentPoints(names.size(), frames), frames);
  const PointDistances distances(frames, points);
  const auto rigid = rigidBodies(distances, kRigid[0] * distances.extent());
  if (rigid.size() == 1 && rigid.front().size() == points.size()) {
    none.reason += ", and its points do not move relative to each other";
    return none;
  }
  for (const double share : kRigid) {
    const PointTree tree(distances, share * distances.extent());
    ShapeGuess guess = guessInTree(tree, names, points, frames);
    if (limbJoints(guess.match) == kLimbJointCount) {
      guess.reason = "bones are distances that stay the same; " + guess.reason;
      return guess;
    }
  }
  none.reason += ", and the distances that stay the same show no arms and legs";
  return none;
}

}  // namespace abstand::tracking
