#include "tracking/joint_guess/skeleton_tree.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"

namespace abstand::tracking {
namespace {

constexpr double kCoincident = 0.02;  // share of a branch's length
constexpr double kSameLength = 0.12;  // share by which left and right of a person may differ

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

TreeBranch SkeletonTree::branch(int child) const {
  TreeBranch out;
  out.from = parents_[static_cast<std::size_t>(child)];
  out.length = own_[static_cast<std::size_t>(child)] + below_[static_cast<std::size_t>(child)];
  double along = 0.0, last = 0.0;
  for (int i = child; i >= 0 && out.nodes.size() < kMaxBranchNodes;
       i = longest_[static_cast<std::size_t>(i)]) {
    along += own_[static_cast<std::size_t>(i)];
    if (along - last <= kCoincident * out.length) continue;
    out.nodes.push_back(i);
    out.along.push_back(along);
    last = along;
  }
  return out;
}

std::vector<BranchPair> SkeletonTree::symmetricPairs() const {
  std::vector<BranchPair> pairs;
  for (std::size_t i = 0; i < children_.size(); ++i) {
    if (children_[i].size() < 2) continue;
    std::vector<int> longest = children_[i];
    const auto length = [this](int c) {
      return own_[static_cast<std::size_t>(c)] + below_[static_cast<std::size_t>(c)];
    };
    std::stable_sort(longest.begin(), longest.end(), [&](int a, int b) { return length(a) > length(b); });
    longest.resize(std::min(longest.size(), kMaxBranches));
    std::vector<TreeBranch> branches;
    for (const int c : longest) branches.push_back(branch(c));
    for (std::size_t a = 0; a < branches.size(); ++a)
      for (std::size_t b = a + 1; b < branches.size(); ++b)
        if (pairs.size() < kMaxBranchPairs && branches[a].nodes.size() >= 3 &&
            isSymmetric(branches[a], branches[b]))
          pairs.push_back({branches[a], branches[b]});
  }
  return pairs;
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
