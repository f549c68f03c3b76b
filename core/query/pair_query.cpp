// Distance, contact and penalty force of two bodies.
#include "core/query/pair_query.hpp"

#include <algorithm>

#include "core/query/pair_search.hpp"
#include "core/query/penalty_force.hpp"
#include "core/query/separation.hpp"

namespace abstand::query {
namespace {

/// The last witness points, moved with the bodies. World frame.
struct TransportedWitnesses {
  TransportedWitnesses(const PairCache& cache, const Transform& X_WA, const Transform& X_WB)
      : on_a(X_WA.linear() * cache.on_a + X_WA.translation()),
        on_b(X_WB.linear() * cache.on_b + X_WB.translation()),
        b_to_a(on_a - on_b),
        distance(b_to_a.norm()) {}
  Vector3d on_a, on_b, b_to_a;
  double distance;
};

/// The most frequent case: the moved witness points are still proven by the hulls.
bool reuseWitnesses(const PlacedBody& a, const PlacedBody& b, const PairOptions& options,
                    const TransportedWitnesses& points, PairCache& cache, PairResult& result) {
  if (!cache.hulls || !(points.distance > kTouching)) return false;
  // The separation along a vector of any length is scaled by that length.
  const double certified = separationAlong(points.b_to_a, a, b, false) / points.distance - kPlaneRounding;
  if (points.distance - certified > tolerance(points.distance, options) || certified <= options.margin)
    return false;
  cache.distance = points.distance;
  result = {};
  result.distance = points.distance;
  result.bound = std::max(0.0, points.distance - certified);
  result.witness_a = points.on_a;
  result.witness_b = points.on_b;
  return true;
}

/// Tries both caches of a pair; the one to start from is then in memory.last.
bool reuseEitherCache(const PlacedBody& a, const PlacedBody& b, const PairOptions& options,
                      PairMemory& memory, PairResult& result) {
  if (!memory.last.apart) return false;
  const TransportedWitnesses points(memory.last, a.X_WB, b.X_WB);
  if (reuseWitnesses(a, b, options, points, memory.last, result)) return true;
  if (!(std::abs(points.distance - memory.last.distance) > kJump)) return false;
  const PairCache before = memory.before_jump;
  memory.before_jump = memory.last;
  if (!before.apart) return false;
  const TransportedWitnesses points_before(before, a.X_WB, b.X_WB);
  if (!(points_before.distance < points.distance)) return false;
  memory.last = before;
  return reuseWitnesses(a, b, options, points_before, memory.last, result);
}

void add(const PenaltyForce& penalty, PairResult& result) {
  result.contacts = penalty.contacts;
  result.depth = std::max(penalty.depth, result.depth);
  result.force_a = penalty.force_a;
  result.torque_a = penalty.torque_a;
  result.torque_b = penalty.torque_b;
}

}  // namespace

bool pointsFromA(const structure::HapticStructure& a, const structure::HapticStructure& b) {
  return a.bounding_sphere.radius <= b.bounding_sphere.radius;
}

bool queryDistance(const PlacedBody& a, const PlacedBody& b, const PairOptions& options,
                   const QueryContext& context, PairResult& result) noexcept {
  const double margin = options.margin;
  if (reuseEitherCache(a, b, options, context.memory, result)) {
    context.memory.last.touching = false;
    return false;
  }
  PairCache& cache = context.memory.last;
  const bool from_a = pointsFromA(a.body, b.body);
  const PlacedBody& F = from_a ? b : a;
  PairSearch search(from_a ? a : b, F, options, cache.part_axes);

  if (!search.warmStart(cache, from_a)) {
    search.search(cache, context.scratch);
    if (search.mayTouch()) search.searchReversed(context.scratch);
  }
  search.store(cache, from_a);
  const Witness& witness = search.witness();
  result = {};
  result.distance = witness.distance;
  result.bound = std::max(0.0, witness.distance - search.certified());
  const Vector3d on_points = F.X_WB * witness.on_points, on_field = F.X_WB * witness.on_field;
  result.witness_a = from_a ? on_points : on_field;
  result.witness_b = from_a ? on_field : on_points;
  result.depth = std::max(margin - witness.distance, 0.0);
  cache.touching = search.certified() <= margin;
  if (!cache.touching) return false;
  const std::optional<PenaltyForce> penalty = search.penalty(from_a);
  if (penalty) add(*penalty, result);
  return !penalty;
}

void addPenalty(const PlacedBody& a, const PlacedBody& b, const PairOptions& options,
                kernels::PairScratch& scratch, PairResult& result) noexcept {
  add(penaltyForce(a, b, options, scratch), result);
}

void queryPair(const PlacedBody& a, const PlacedBody& b, const PairOptions& options,
               const QueryContext& context, PairResult& result) noexcept {
  if (queryDistance(a, b, options, context, result)) addPenalty(a, b, options, context.scratch, result);
}

void queryPair(const PlacedBody& a, const PlacedBody& b, const PairOptions& options,
               kernels::PairScratch& scratch, PairResult& result) noexcept {
  PairMemory memory;
  queryPair(a, b, options, {memory, scratch}, result);
}

}  // namespace abstand::query
