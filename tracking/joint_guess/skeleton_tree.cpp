#include "tracking/joint_guess/skeleton_tree.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"

namespace abstand::tracking {
namespace {

constexpr double kCoincident = 0.02;    // share of a branch's length
constexpr double kSameLength = 0.12;    // share by which left and right of a person may differ
constexpr std::size_t kMaxBelow = 300;  // joints of a branch among which the highest is searched
constexpr std::size_t kMaxSteps = 64;   // joints looked at for the next ones

/// The same lengths, as far as both go.
bool isSymmetric(const TreeBranch& a, const TreeBranch& b) {
  if (!(a.length > 0.0) || !(b.length > 0.0)) return false;
  if (std::abs(a.length - b.length) > kSameLength * std::max(a.length, b.length)) return false;
  const std::size_t n = std::min(a.nodes.size(), b.nodes.size());
  if (std::max(a.nodes.size(), b.nodes.size()) > n + 1) return false;
  for (std::size_t i = 0; i + 1 < n; ++i)
    if (std::abs(a.along[i] - b.along[i]) > kSameLength * std::max(a.length, b.length)) return false;
  return true;
}

}  // namespace

SkeletonTree::SkeletonTree(std::span<const int> parents, std::span<const Vector3d> positions)
    : parents_{parents},
      p_{positions},
      children_(parents.size()),
      own_(parents.size(), 0.0),
      below_(parents.size(), 0.0),
      longest_(parents.size(), -1) {
  ABSTAND_CHECK(parents.size() == positions.size());
  for (std::size_t i = 0; i < parents.size(); ++i) {
    if (parents[i] < 0) continue;
    const auto parent = static_cast<std::size_t>(parents[i]);
    ABSTAND_CHECK(parent < i);
    children_[parent].push_back(static_cast<int>(i));
    own_[i] = (p_[i] - p_[parent]).norm();
  }
  for (std::size_t i = parents.size(); i-- > 0;) {
    if (parents[i] < 0) continue;
    const auto parent = static_cast<std::size_t>(parents[i]);
    const double path = own_[i] + below_[i];
    if (longest_[parent] < 0 || path >= below_[parent]) {
      below_[parent] = path;
      longest_[parent] = static_cast<int>(i);
    }
  }
}

template <typename Next>
TreeBranch SkeletonTree::branchAlong(int child, double length, const Next& next) const {
  TreeBranch out;
  out.from = parents_[static_cast<std::size_t>(child)];
  out.length = length;
  double along = 0.0, last = 0.0;
  for (int i = child; i >= 0 && out.nodes.size() < kMaxBranchNodes; i = next(i)) {
    along += own_[static_cast<std::size_t>(i)];
    if (along - last <= kCoincident * out.length) continue;
    out.nodes.push_back(i);
    out.along.push_back(along);
    last = along;
  }
  return out;
}

TreeBranch SkeletonTree::branch(int child) const {
  return branchAlong(child, pathOf(child), [&](int i) { return longest_[static_cast<std::size_t>(i)]; });
}

TreeBranch SkeletonTree::highestBranch(int child, const Vector3d& up) const {
  const auto height = [&](int i) { return p_[static_cast<std::size_t>(i)].dot(up); };
  std::vector<int> below{child};
  for (std::size_t i = 0; i < below.size(); ++i)
    for (const int next : children(below[i]))
      if (below.size() < kMaxBelow) below.push_back(next);
  std::vector<int> path{*std::ranges::max_element(below, {}, height)};
  while (path.back() != child) path.push_back(parents_[static_cast<std::size_t>(path.back())]);
  double length = 0.0;
  for (const int i : path) length += own_[static_cast<std::size_t>(i)];
  return branchAlong(child, length, [&](int) {
    path.pop_back();
    return path.empty() ? -1 : path.back();
  });
}

template <typename Use>
void SkeletonTree::forPairs(const Use& use) const {
  for (const auto& children : children_) {
    if (children.size() < 2) continue;
    std::vector<int> longest = children;
    std::stable_sort(longest.begin(), longest.end(), [&](int a, int b) { return pathOf(a) > pathOf(b); });
    longest.resize(std::min(longest.size(), kMaxBranches));
    for (std::size_t a = 0; a < longest.size(); ++a)
      for (std::size_t b = a + 1; b < longest.size(); ++b) use(longest[a], longest[b]);
  }
}

std::vector<BranchPair> SkeletonTree::symmetricPairs() const {
  std::vector<BranchPair> pairs;
  forPairs([&](int first, int second) {
    if (pairs.size() >= kMaxBranchPairs) return;
    TreeBranch a = branch(first), b = branch(second);
    if (a.nodes.size() < kMinPairNodes || !isSymmetric(a, b)) return;
    const std::size_t common = std::min(a.nodes.size(), b.nodes.size());
    const double length = 0.5 * (a.length + b.length);
    pairs.push_back({std::move(a), std::move(b), common, length, true});
  });
  return pairs;
}

std::vector<BranchPair> SkeletonTree::partlySymmetricPairs() const {
  std::vector<BranchPair> pairs;
  forPairs([&](int first, int second) {
    if (pairs.size() >= kMaxBranchPairs || isSymmetric(branch(first), branch(second))) return;
    if (BranchPair pair = commonPart(first, second); pair.common >= kMinPairNodes)
      pairs.push_back(std::move(pair));
  });
  return pairs;
}

/// The next joints on all ways down that are farther than `shortest`.
std::vector<SkeletonTree::Step> SkeletonTree::steps(const std::vector<int>& children, double shortest) const {
  std::vector<Step> open, found;
  const auto push = [&](const std::vector<int>& joints, double length) {
    for (std::size_t i = 0; i < joints.size() && open.size() < kMaxSteps; ++i)
      open.push_back({joints[i], length + own_[static_cast<std::size_t>(joints[i])]});
  };
  push(children, 0.0);
  for (std::size_t i = 0; i < open.size(); ++i) {
    const Step step = open[i];
    if (step.length > shortest)
      found.push_back(step);
    else
      push(children_[static_cast<std::size_t>(step.joint)], step.length);
  }
  std::stable_sort(found.begin(), found.end(), [this](const Step& a, const Step& b) {
    return below_[static_cast<std::size_t>(a.joint)] > below_[static_cast<std::size_t>(b.joint)];
  });
  found.resize(std::min(found.size(), kMaxBranches));
  return found;
}

/// The joints below two children of one joint, as far as the bones of both have the same lengths; where the
/// ways branch, along those that go on farthest on both sides.
BranchPair SkeletonTree::commonPart(int a, int b) const {
  BranchPair pair;
  pair.is_whole = false;
  pair.a.from = pair.b.from = parents_[static_cast<std::size_t>(a)];
  const double reference = std::min(pathOf(a), pathOf(b)), shortest = kCoincident * reference;
  std::vector<int> from_a{a}, from_b{b};
  while (pair.common < kMaxBranchNodes) {
    Step best_a, best_b;
    double farthest = -1.0;
    const auto all_b = steps(from_b, shortest);
    for (const Step& s : steps(from_a, shortest))
      for (const Step& t : all_b) {
        // Where the limbs begin may differ more: only the bones of the limbs are compared.
        const double longer = pair.common == 0 ? reference : std::max(s.length, t.length);
        const double on =
            std::min(below_[static_cast<std::size_t>(s.joint)], below_[static_cast<std::size_t>(t.joint)]);
        if (std::abs(s.length - t.length) > kSameLength * longer || on <= farthest) continue;
        farthest = on;
        best_a = s;
        best_b = t;
      }
    if (farthest < 0.0) break;
    const auto add = [](TreeBranch& branch, const Step& step) {
      branch.nodes.push_back(step.joint);
      branch.along.push_back((branch.along.empty() ? 0.0 : branch.along.back()) + step.length);
    };
    add(pair.a, best_a);
    add(pair.b, best_b);
    ++pair.common;
    from_a = children(best_a.joint);
    from_b = children(best_b.joint);
  }
  if (pair.common == 0) return pair;
  pair.length = 0.5 * (pair.a.along.back() + pair.b.along.back()) +
                std::min(below_[static_cast<std::size_t>(pair.a.nodes.back())],
                         below_[static_cast<std::size_t>(pair.b.nodes.back())]);
  goOn(pair.a, shortest);
  goOn(pair.b, shortest);
  return pair;
}

/// Adds the longest way below the last node.
void SkeletonTree::goOn(TreeBranch& branch, double shortest) const {
  double along = branch.along.back();
  branch.length = along + below_[static_cast<std::size_t>(branch.nodes.back())];
  for (int i = longest_[static_cast<std::size_t>(branch.nodes.back())];
       i >= 0 && branch.nodes.size() < kMaxBranchNodes; i = longest_[static_cast<std::size_t>(i)]) {
    along += own_[static_cast<std::size_t>(i)];
    if (along - branch.along.back() <= shortest) continue;
    branch.nodes.push_back(i);
    branch.along.push_back(along);
  }
}

bool SkeletonTree::isBelow(int joint, int ancestor) const {
  while (joint > ancestor) joint = parents_[static_cast<std::size_t>(joint)];
  return joint == ancestor;
}

std::vector<int> SkeletonTree::between(int a, int b) const {
  std::vector<int> up, down;
  int i = a;
  while (i >= 0 && !isBelow(b, i)) {
    i = parents_[static_cast<std::size_t>(i)];
    if (i >= 0 && !isBelow(b, i)) up.push_back(i);
  }
  for (int k = b; k >= 0 && k != i;) {
    k = parents_[static_cast<std::size_t>(k)];
    if (k >= 0 && k != i) down.push_back(k);
  }
  up.insert(up.end(), down.rbegin(), down.rend());
  return up;
}

}  // namespace abstand::tracking
