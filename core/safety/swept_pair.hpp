// Certified minimum distance of two moving bodies over a time interval.
#pragma once

#include "core/query/pair_query.hpp"
#include "core/safety/body_motion.hpp"
#include "core/safety/swept_distance.hpp"

namespace abstand::safety {

/// Work space of one swept query; one for each pair or thread. Its pair memory speeds up the next query of
/// the same two structures.
struct SweptScratch {
  query::PairMemory memory;
  kernels::PairScratch scratch;
  query::PairResult result;
};

/// External work space of a swept query.
struct SweptContext {
  query::PairMemory& memory;
  kernels::PairScratch& scratch;
  query::PairResult& result;
  const SweptEnds* ends{nullptr};  ///< null: both ends are queried, too
};

/// A body and its motion over [0, duration].
struct MovingBody {
  const structure::HapticStructure& body;
  BodyMotion& motion;
};

/// Calls queryPair() at selected times of [0, duration]. `lower` is a lower bound of the distance for any
/// motion within the bounds of `a` and `b`; `upper` is the smallest sampled distance for the poses of both,
/// minus slack. Distances are between bare surfaces, without margins. No allocation, no throw.
SweptResult sweptPair(const MovingBody& a, const MovingBody& b, double duration, const SweptOptions& options,
                      const SweptContext& context) noexcept;
inline SweptResult sweptPair(const MovingBody& a, const MovingBody& b, double duration,
                             const SweptOptions& options, SweptScratch& s) noexcept {
  return sweptPair(a, b, duration, options, SweptContext{s.memory, s.scratch, s.result});
}

}  // namespace abstand::safety
