// The smallest distance of two moving bodies over a stretch of time, certified like that of one posture.
#pragma once

#include "core/query/pair_query.hpp"
#include "core/safety/body_motion.hpp"
#include "core/safety/swept_distance.hpp"

namespace abstand::safety {

/// Work space of one swept query; one per pair or thread. What is remembered speeds up the next query of the
/// same two structures.
struct SweptScratch {
  query::PairMemory memory;
  kernels::PairScratch scratch;
  query::PairResult result;
};

/// Where a swept query works, in place of a scratch of its own.
struct SweptContext {
  query::PairMemory& memory;
  kernels::PairScratch& scratch;
  query::PairResult& result;
  const SweptEnds* ends{nullptr};  ///< null: both ends are asked, too
};

/// A body and its motion over [0, duration].
struct MovingBody {
  const structure::HapticStructure& body;
  BodyMotion& motion;
};

/// Asks queryPair() at chosen times of [0, duration]. `lower` is never above the smallest distance that any
/// motion within the bounds of `a` and `b` can bring; `upper` is the smallest that was seen with the poses of
/// both (slack taken off). Distances are between bare surfaces, without margins. No allocation, no throw.
SweptResult sweptPair(const MovingBody& a, const MovingBody& b, double duration, const SweptOptions& options,
                      const SweptContext& context) noexcept;
inline SweptResult sweptPair(const MovingBody& a, const MovingBody& b, double duration,
                             const SweptOptions& options, SweptScratch& s) noexcept {
  return sweptPair(a, b, duration, options, SweptContext{s.memory, s.scratch, s.result});
}

}  // namespace abstand::safety
