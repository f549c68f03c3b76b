// The queries of a step, on several threads.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/base/id.hpp"
#include "core/query/pair_query.hpp"
#include "core/scene/motion_bound.hpp"
#include "core/scene/query_culling.hpp"
#include "core/scene/query_queue.hpp"
#include "core/scene/scene_object.hpp"
#include "core/scene/scene_pair.hpp"

namespace abstand::scene {

class PairWorkers;

/// Brings results up to the present poses, and leaves out the queries that culling allows to. Which thread
/// queries which pair is left to chance and changes no bit. One owner thread; run() allocates nothing.
class PairQueries {
 public:
  /// Seconds from any beginning.
  using Clock = double (*)();
  /// The scene's tables: all of its pairs and objects, and how far each object has moved.
  struct Tables {
    PairTable& pairs;
    std::span<const Object> objects;
    std::span<const MotionBound> bounds;
  };

  PairQueries();
  ~PairQueries();
  PairQueries(PairQueries&&) noexcept;
  PairQueries& operator=(PairQueries&&) noexcept;

  /// As Scene::setThreads, but at least 1.
  void setThreads(int threads);
  int threads() const { return threads_; }
  /// Of valid options, for a scene with these pairs; forgets what warm starts remember.
  void setCulling(const QueryCulling& culling, const PairTable& pairs);
  const QueryCulling& culling() const { return culling_; }
  void setClock(Clock clock) { clock_ = clock; }
  /// After a pair was added.
  void makeRoom(const PairTable& pairs);
  /// Forgets what warm starts remember. No allocation.
  void startCold() noexcept;

  /// When the time budget of a step that begins now is used up, by the clock; infinity without a budget.
  double deadline() const { return culling_.limited() ? clock_() + culling_.budget : kInfinity; }
  /// Every pair of `list` gets its outcome and, unless it is paused, a result for the present poses.
  void run(const std::vector<PairId>& list, const Tables& tables, double deadline);

 private:
  struct Scratch;
  template <class Task>
  void forEach(const std::vector<PairId>& list, PairTable& pairs, Task task);
  void check(Pair& pair, const Tables& tables, kernels::PairScratch& scratch);
  void visit(Pair& pair, const Tables& tables, kernels::PairScratch& scratch);
  void queryUntil(double deadline, const std::vector<PairId>& list, const Tables& tables);

  QueryCulling culling_;
  Clock clock_;
  std::vector<query::PairMemory> memories_;  ///< of the pairs, where culling_.remember
  QueryQueue queue_;                         ///< pairs deferred in this step
  std::vector<PairId> batch_;
  std::vector<Scratch> scratch_;  ///< of each thread
  std::unique_ptr<PairWorkers> workers_;
  int threads_{1};
};

}  // namespace abstand::scene
