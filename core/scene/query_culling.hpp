// Options of query culling, and their effect on certainty.
#pragma once

#include "core/query/pair_query.hpp"

namespace abstand::scene {

/// Default: all off, every pair with a moved body is queried. With culling the true distance is still never
/// below distance - bound; only the bound grows.
struct QueryCulling {
  /// 0 to 1. A pair is not queried until the motion of its bodies has used up this share of its clearance,
  /// that is of the certified distance beyond margins and field errors at the last query. At 0.01 the bound
  /// grows by at most two hundredths of the clearance; 1 is the largest share at which no margin can be
  /// violated. 0: off.
  double rest{0.0};
  /// m. A pair whose bounding spheres are farther apart than this is not queried.
  double horizon{kInfinity};
  /// s, time budget of a step. When it is used up, remaining pairs keep their last proof, with a bound that
  /// grows with the motion of their bodies, and are queried in later steps (query_queue.hpp). Bounds then
  /// depend on the speed of the machine. Pairs without a proof are always queried.
  double budget{kInfinity};

  /// Warm start: queries use the pair's memory of the step before (PairMemory). Several times faster. Beyond
  /// 0.1 m a distance may exceed the smallest one of the shell points by the share far_tolerance (included in
  /// `bound`), and within these limits results depend on the steps since the last cold start
  /// (Scene::startCold). They never depend on the number of threads.
  bool remember{false};
  double far_tolerance{query::kFarTolerance};
  /// far_tolerance as a share of the reported distance, for PairOptions.
  double farShare() const { return remember ? query::farShareOf(far_tolerance) : query::kColdFarShare; }

  bool any() const { return rest > 0.0 || horizon < kInfinity || limited(); }
  bool limited() const { return budget < kInfinity; }
  /// Throws UsageError with name, value and rule.
  void validate() const;
};

}  // namespace abstand::scene
