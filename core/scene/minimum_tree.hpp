// Minimum of many numbers with few changes at a time.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/huge_pages.hpp"
#include "core/math/transform.hpp"

namespace abstand::scene {

/// Tournament tree: each inner node holds the smaller of its two children; a change propagates only as far as
/// needed. NaN counts as infinity. One thread.
class MinimumTree {
 public:
  /// Resets all values; allocates.
  void resize(std::size_t count) {
    count_ = count;
    leaves_ = std::bit_ceil(std::max<std::size_t>(count, 1));
    node_.assign(2 * leaves_, kInfinity);
  }

  void set(std::size_t i, double value) {
    std::size_t n = leaves_ + i;
    node_[n] = value < kInfinity ? value : kInfinity;
    for (n /= 2; n > 0; n /= 2) {
      const double smaller = std::min(node_[2 * n], node_[2 * n + 1]);
      if (smaller == node_[n]) return;
      node_[n] = smaller;
    }
  }

  /// Index of the smallest value, the first of equal ones; nullopt if all are infinite.
  std::optional<std::size_t> smallest() const {
    if (count_ == 0 || !(node_[1] < kInfinity)) return std::nullopt;
    std::size_t n = 1;
    while (n < leaves_) n = node_[2 * n] == node_[n] ? 2 * n : 2 * n + 1;
    return n - leaves_;
  }
  /// The smallest value; infinity if there is none.
  double minimum() const { return count_ == 0 ? kInfinity : node_[1]; }
  std::size_t size() const { return count_; }

 private:
  std::vector<double, HugePageAllocator<double>>
      node_;  ///< node n has the children 2 n and 2 n + 1; leaves from leaves_ on
  std::size_t count_{0}, leaves_{1};
};

}  // namespace abstand::scene
