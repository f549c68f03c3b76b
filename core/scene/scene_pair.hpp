// A pair of bodies in the scene, and statistics of the outcomes of a step.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/huge_pages.hpp"
#include "core/base/id.hpp"
#include "core/query/pair_query.hpp"
#include "core/scene/temporal_culling.hpp"

namespace abstand::scene {

/// Cache-line aligned to avoid false sharing; hot fields first.
struct alignas(64) Pair {
  ObjectId a, b;
  PairOutcome outcome{PairOutcome::kChecked};
  bool queued{false};    ///< the next step updates it
  bool touching{false};  ///< is in Scene::touching()
  bool paused{false};    ///< see Scene::setPaused
  int waited{0};         ///< steps since it was deferred
  TemporalCulling culling;
  query::PairResult result;
  query::PairOptions options;  ///< margin: margin_a + margin_b, or that of setPairMargin
};

using PairTable = std::vector<Pair, HugePageAllocator<Pair>>;

/// The pairs of a list are far apart in memory: prefetches one some positions after `i`.
inline void prefetchAhead(const PairTable& pairs, const std::vector<PairId>& list, std::size_t i) {
  constexpr std::size_t kAhead = 8;
  if (i + kAhead >= list.size()) return;
  const char* line = reinterpret_cast<const char*>(&pairs[list[i + kAhead].index()]);
  for (std::size_t k = 0; k < 3; ++k) __builtin_prefetch(line + 64 * k, 1);
}

/// Outcomes of the pairs in a step; pairs without motion are not counted.
struct StepCounts {
  long checked{0}, rested{0}, beyond{0}, deferred{0};
  int longest_wait{0};  ///< in steps, of the deferred pairs
};

}  // namespace abstand::scene
