// What a scene may leave out in a step, and what that costs in certainty.
#pragma once

#include "core/query/pair_query.hpp"

namespace abstand::scene {

inline constexpr double kMaxFarTolerance = 0.1;

/// All off by default: every pair of something that moved is queried. Whatever is left out, the true distance
/// of a pair is never below distance - bound; it is the bound that grows.
struct QueryCulling {
  /// 0 to 1. A pair rests until its bodies have used up this share of its clearance by moving: of the
  /// certified distance beyond margins and field errors, at the last query. At 0.01 the bound grows by two
  /// hundredths of the clearance at most; 1 is the longest rest in which no margin can be broken. 0: none
  /// rests.
  double rest{0.0};
  /// m. A pair whose bounding spheres are farther apart than this is not queried.
  double horizon{kInfinity};
  /// s, of a step from its beginning. When it is used up, the pairs that ought still to be queried keep what
  /// was proven of them, with a bound that grows as their bodies move, and are taken up in the steps that
  /// follow (query_queue.hpp). What is proven then depends on the machine's speed. Pairs of which nothing is
  /// proven yet are queried in any case.
  double budget{kInfinity};

  /// Warm start: pairs start from what they remember of the step before (PairMemory). Several times as fast,
  /// and farther away than 0.1 m up to far_tolerance above the smallest distance of the points (which `bound`
  /// covers); and a step's numbers depend, within these limits, on the steps since the last one that was cold
  /// (Scene::startCold). They never depend on the number of threads.
  bool remember{false};
  double far_tolerance{0.002};
  /// The same as a share of the answer, as PairOptions wants it.
  double farShare() const { return remember ? far_tolerance / (1.0 + far_tolerance) : query::kColdFarShare; }

  bool any() const { return rest > 0.0 || horizon < kInfinity || limited(); }
  bool limited() const { return budget < kInfinity; }
  /// Throws UsageError with the name, the value and the rule.
  void validate() const;
};

}  // namespace abstand::scene
