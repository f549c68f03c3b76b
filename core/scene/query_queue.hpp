// Priority queue of deferred queries.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/base/id.hpp"

namespace abstand::scene {

/// A pair whose query is due.
struct QueuedPair {
  PairId id;
  bool may_touch;    ///< contact is not excluded
  int waited;        ///< steps since the query became due
  double clearance;  ///< m, certified beyond margins
};

/// Order: pairs that may touch, then those that have waited longest, then the nearest, so that no pair
/// starves and near pairs are queried more often. Ties in scene order. One thread; add() and next() allocate
/// nothing within the reserved size.
class QueryQueue {
 public:
  void reserve(std::size_t pairs) { heap_.reserve(pairs); }
  void clear() { heap_.clear(); }
  bool empty() const { return heap_.empty(); }

  /// All add() calls precede the first next().
  void add(const QueuedPair& pair) { heap_.push_back(pair); }
  void heapify() { std::make_heap(heap_.begin(), heap_.end(), later); }
  PairId next() {
    std::pop_heap(heap_.begin(), heap_.end(), later);
    const PairId id = heap_.back().id;
    heap_.pop_back();
    return id;
  }

 private:
  static bool later(const QueuedPair& x, const QueuedPair& y) {
    if (x.may_touch != y.may_touch) return y.may_touch;
    if (x.waited != y.waited) return x.waited < y.waited;
    if (x.clearance != y.clearance) return x.clearance > y.clearance;
    return x.id > y.id;
  }

  std::vector<QueuedPair> heap_;
};

}  // namespace abstand::scene
