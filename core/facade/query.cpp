#include "abstand/query.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "core/base/parallel.hpp"
#include "core/facade/structure_impl.hpp"

namespace abstand {
namespace {

std::size_t batchSize(std::size_t a, std::size_t b) {
  if (a != b && a != 1 && b != 1)
    throw UsageError("found " + std::to_string(a) + " poses of A and " + std::to_string(b) +
                     " of B, expected as many or one of either");
  return std::min(a, b) == 0 ? 0 : std::max(a, b);
}

void checkPoses(std::span<const Pose> poses) {
  for (const Pose& X : poses) facade::checkedPose(X);
}

/// Sequential queries; `memory` may be null.
struct SequentialQuery {
  const structure::HapticStructure &a, &b;
  std::span<const Pose> X_WA, X_WB;
  const query::PairOptions& options;
  std::span<PairResult> results;

  void run(std::size_t i, query::PairMemory* memory, kernels::PairScratch& scratch) const {
    const Transform A(X_WA[X_WA.size() == 1 ? 0 : i]), B(X_WB[X_WB.size() == 1 ? 0 : i]);
    query::PairResult result;
    if (memory)
      query::queryPair({a, A}, {b, B}, options, {*memory, scratch}, result);
    else
      query::queryPair({a, A}, {b, B}, options, scratch, result);
    results[i] = facade::resultOf(result);
  }
};

}  // namespace

PairState::PairState() : impl_(std::make_unique<Impl>()) {}
PairState::~PairState() = default;
PairState::PairState(PairState&&) noexcept = default;
PairState& PairState::operator=(PairState&&) noexcept = default;
void PairState::reset() noexcept { *impl_ = Impl(); }

PairResult queryPair(const Structure& a, const Pose& X_WA, const Structure& b, const Pose& X_WB,
                     const QueryOptions& options) {
  kernels::PairScratch scratch;
  query::PairResult result;
  query::queryPair({*a.impl().made, facade::checkedPose(X_WA)}, {*b.impl().made, facade::checkedPose(X_WB)},
                   facade::coldOptions(options), scratch, result);
  return facade::resultOf(result);
}

PairResult queryPair(const Structure& a, const Pose& X_WA, const Structure& b, const Pose& X_WB,
                     const QueryOptions& options, PairState& state) {
  kernels::PairScratch scratch;
  query::PairResult result;
  query::queryPair({*a.impl().made, facade::checkedPose(X_WA)}, {*b.impl().made, facade::checkedPose(X_WB)},
                   facade::warmOptions(options), {state.impl().memory, scratch}, result);
  return facade::resultOf(result);
}

void queryPoses(const Structure& a, std::span<const Pose> X_WA, const Structure& b,
                std::span<const Pose> X_WB, const BatchOptions& options, std::span<PairResult> results) {
  const std::size_t count = batchSize(X_WA.size(), X_WB.size());
  if (results.size() != count)
    throw UsageError("found room for " + std::to_string(results.size()) + " results, expected " +
                     std::to_string(count));
  if (options.threads < 0) throw UsageError("found a negative number of threads, expected 0 or more");
  checkPoses(X_WA);
  checkPoses(X_WB);
  const query::PairOptions pair_options =
      options.sequence ? facade::warmOptions(options.query) : facade::coldOptions(options.query);
  const SequentialQuery sequence{*a.impl().made, *b.impl().made, X_WA, X_WB, pair_options, results};
  const auto runBlock = [&](std::size_t block) {
    kernels::PairScratch scratch;
    query::PairMemory memory;
    const std::size_t end = std::min(count, (block + 1) * kBatchBlock);
    for (std::size_t i = block * kBatchBlock; i < end; ++i)
      sequence.run(i, options.sequence ? &memory : nullptr, scratch);
  };
  parallelFor(options.threads, (count + kBatchBlock - 1) / kBatchBlock, runBlock);
}

std::vector<PairResult> queryPoses(const Structure& a, std::span<const Pose> X_WA, const Structure& b,
                                   std::span<const Pose> X_WB, const BatchOptions& options) {
  std::vector<PairResult> results(batchSize(X_WA.size(), X_WB.size()));
  queryPoses(a, X_WA, b, X_WB, options, results);
  return results;
}

}  // namespace abstand

namespace abstand::facade {

query::PairOptions coldOptions(const QueryOptions& options) {
  if (!(options.margin >= 0.0) || !std::isfinite(options.margin))
    throw UsageError("found a margin that is negative or not finite, expected 0 m or more");
  if (!(options.stiffness >= 0.0) || !std::isfinite(options.stiffness))
    throw UsageError("found a stiffness that is negative or not finite, expected 0 or more");
  if (!(options.far_tolerance >= 0.0 && options.far_tolerance <= query::kMaxFarTolerance))
    throw UsageError("found a tolerance out of range, expected a share from 0 to 0.1");
  query::PairOptions o{.margin = options.margin, .stiffness = options.stiffness};
  o.law = options.law == QueryOptions::Law::kThesis ? query::ForceLaw::kThesis : query::ForceLaw::kVolume;
  return o;
}

query::PairOptions warmOptions(const QueryOptions& options) {
  query::PairOptions o = coldOptions(options);
  o.far_share = query::farShareOf(options.far_tolerance);
  return o;
}

PairResult resultOf(const query::PairResult& r) {
  PairResult result;
  result.distance = r.distance;
  result.bound = r.bound;
  result.witness_a = r.witness_a;
  result.witness_b = r.witness_b;
  result.force_a = r.force_a;
  result.torque_a = r.torque_a;
  result.torque_b = r.torque_b;
  result.contacts = r.contacts;
  result.depth = r.depth;
  return result;
}

Transform checkedPose(const Pose& pose) {
  const Transform X(pose);
  if (!isPose(X)) throw UsageError("found a pose that is not finite or no rotation, expected a rigid motion");
  return X;
}

}  // namespace abstand::facade
