#include "core/scene/pair_queries.hpp"

#include <algorithm>
#include <chrono>

#include "core/scene/pair_workers.hpp"

namespace abstand::scene {
namespace {

double steadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Queries of a thread between two checks of the clock.
constexpr std::size_t kBatch = 8;

}  // namespace

/// Cache-line aligned.
struct alignas(64) PairQueries::Scratch {
  kernels::PairScratch of_query;
};

PairQueries::PairQueries() : clock_(steadySeconds), scratch_(1) { batch_.reserve(kBatch); }
PairQueries::~PairQueries() = default;
PairQueries::PairQueries(PairQueries&&) noexcept = default;
PairQueries& PairQueries::operator=(PairQueries&&) noexcept = default;

void PairQueries::setThreads(int threads) {
  if (threads == threads_) return;
  workers_.reset();
  threads_ = 1;
  scratch_.resize(static_cast<std::size_t>(threads));
  batch_.reserve(scratch_.size() * kBatch);
  if (threads > 1) workers_ = std::make_unique<PairWorkers>(threads - 1);
  threads_ = threads;
}

void PairQueries::setCulling(const QueryCulling& culling, const PairTable& pairs) {
  culling_ = culling;
  if (culling.limited()) queue_.reserve(pairs.capacity());
  memories_.assign(culling.remember ? pairs.size() : 0, {});
}

void PairQueries::reserve(const PairTable& pairs) {
  if (culling_.limited()) queue_.reserve(pairs.capacity());
  if (culling_.remember) memories_.resize(pairs.size());
}

void PairQueries::startCold() noexcept { std::fill(memories_.begin(), memories_.end(), query::PairMemory{}); }

/// Calls task(pair, scratch) for each pair, on all threads.
template <class Task>
void PairQueries::forEach(const std::vector<PairId>& list, PairTable& pairs, Task task) {
  struct Context {
    const std::vector<PairId>& list;
    PairTable& pairs;
    std::vector<Scratch>& scratch;
    Task& task;
  } context{list, pairs, scratch_, task};
  const auto one = [](void* c, std::size_t i, std::size_t thread) {
    const Context& of = *static_cast<Context*>(c);
    prefetchAhead(of.pairs, of.list, i);
    of.task(of.pairs[of.list[i].index()], of.scratch[thread].of_query);
  };
  if (workers_) {
    workers_->run(list.size(), one, &context);
  } else {
    for (std::size_t i = 0; i < list.size(); ++i) one(&context, i, 0);
  }
}

void PairQueries::query(Pair& pair, const Tables& tables, kernels::PairScratch& scratch) {
  const Object& a = tables.objects[pair.a.index()];
  const Object& b = tables.objects[pair.b.index()];
  query::PairMemory nothing;
  query::PairMemory& memory =
      culling_.remember ? memories_[static_cast<std::size_t>(&pair - tables.pairs.data())] : nothing;
  query::queryPair({*a.spec.structure, a.X_WB}, {*b.spec.structure, b.X_WB}, pair.options, {memory, scratch},
                   pair.result);
  pair.outcome = PairOutcome::kChecked;
  if (!culling_.any()) return;
  pair.culling.update(pair.result, {a.X_WB, tables.bounds[pair.a.index()]},
                      {b.X_WB, tables.bounds[pair.b.index()]},
                      contactDistance(*a.spec.structure, *b.spec.structure, pair.options), culling_);
}

void PairQueries::update(Pair& pair, const Tables& tables, kernels::PairScratch& scratch) {
  if (pair.paused) return;
  const MotionBound& a = tables.bounds[pair.a.index()];
  const MotionBound& b = tables.bounds[pair.b.index()];
  pair.outcome = culling_.any() ? pair.culling.outcome(a, b, culling_) : PairOutcome::kChecked;
  if (pair.outcome == PairOutcome::kChecked) {
    // With a time budget, the proven bound is used until the pair is queried.
    if (!culling_.limited() || !pair.culling.proven()) return query(pair, tables, scratch);
    pair.outcome = PairOutcome::kDeferred;
  }
  pair.culling.proof().carry(tables.objects[pair.a.index()].X_WB, tables.objects[pair.b.index()].X_WB,
                             pair.culling.lowerNow(a, b), pair.result);
}

/// Queries deferred pairs, the most urgent first, until the deadline; at least one batch, so that no pair
/// starves.
void PairQueries::queryUntil(double deadline, const std::vector<PairId>& list, const Tables& tables) {
  queue_.clear();
  for (const PairId id : list) {
    const Pair& pair = tables.pairs[id.index()];
    if (pair.outcome != PairOutcome::kDeferred) continue;
    const double clearance = pair.result.distance - pair.result.bound - pair.culling.contactDistance();
    queue_.add({id, clearance <= 0.0, pair.waited, clearance});
  }
  queue_.heapify();
  do {
    batch_.clear();
    while (!queue_.empty() && batch_.size() < kBatch * scratch_.size()) batch_.push_back(queue_.next());
    forEach(batch_, tables.pairs,
            [&](Pair& pair, kernels::PairScratch& scratch) { query(pair, tables, scratch); });
  } while (!queue_.empty() && clock_() < deadline);
}

void PairQueries::run(const std::vector<PairId>& list, const Tables& tables, double deadline) {
  forEach(list, tables.pairs,
          [&](Pair& pair, kernels::PairScratch& scratch) { update(pair, tables, scratch); });
  if (culling_.limited()) queryUntil(deadline, list, tables);
}

}  // namespace abstand::scene
