// A pair of bodies in the scene, and how the pairs of a step came to their results.
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
  bool queued{false};    ///< the next step() looks at it
  bool touching{false};  ///< is among Scene::touching()
  bool paused{false};    ///< see Scene::setPaused
  int waited{0};         ///< steps that it has been deferred
  TemporalCulling rest;
  query::PairResult result;
  query::PairOptions options;  ///< margin = margin_a + margin_b, kept up to date by setMargin
};

using PairTable = std::vector<Pair, HugePageAllocator<Pair>>;

/// The pairs of a list lie far apart in memory: asks for the one some places after place `i`.
inline void prefetchAhead(const PairTable& pairs, const std::vector<PairId>& list, std::size_t i) {
  constexpr std::size_t kAhead = 8;
  if (i + kAhead >= list.size()) return;
  const char* line = reinterpret_cast<const char*>(&pairs[list[i + kAhead].index()]);
  for (std::size_t k = 0; k < 3; ++k) __builtin_prefetch(line + 64 * k, 1);
}

/// How the pairs of a step came to their results; those that nothing moved do not count.
struct StepCounts {
  long checked{0}, rested{0}, beyond{0}, deferred{0};
  int longest_wait{0};  ///< steps, of the pairs deferred
};

}  // namespace abstand::scene
