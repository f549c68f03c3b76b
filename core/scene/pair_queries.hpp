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

/// Updates results to the current poses, skipping queries by culling. The assignment of pairs to threads is
/// not deterministic and does not affect the results. One owner thread; run() allocates nothing.
class PairQueries {
 public:
  /// Seconds since any fixed time.
  using Clock = double (*)();
  /// The scene's tables: all pairs, objects and motion bounds.
  struct Tables {
    PairTable& pairs;
    std::span<const Object> objects;
    std::span<const MotionBound> bounds;
  };

  PairQueries();
  ~PairQueries();
  PairQueries(PairQueries&&) noexcept;
  PairQueries& operator=(PairQueries&&) noexcept;

  /// As Scene::setThreads, but `threads` is at least 1.
  void setThreads(int threads);
  int threads() const { return threads_; }
  /// Sets valid options for a scene with these pairs; clears the memories of warm starts.
  void setCulling(const QueryCulling& culling, const PairTable& pairs);
  const QueryCulling& culling() const { return culling_; }
  void setClock(Clock clock) { clock_ = clock; }
  /// Call after adding a pair.
  void reserve(const PairTable& pairs);
  /// Clears the memories of warm starts. No allocation.
  void startCold() noexcept;

  /// Deadline (clock time, s) of a step that starts now; infinity without a time budget.
  double deadline() const { return culling_.limited() ? clock_() + culling_.budget : kInfinity; }
  /// Every pair of `list` gets an outcome and, unless it is paused, a result for the current poses.
  void run(const std::vector<PairId>& list, const Tables& tables, double deadline);

 private:
  struct Scratch;
  template <class Task>
  void forEach(const std::vector<PairId>& list, PairTable& pairs, Task task);
  void query(Pair& pair, const Tables& tables, kernels::PairScratch& scratch);
  void update(Pair& pair, const Tables& tables, kernels::PairScratch& scratch);
  void queryUntil(double deadline, const std::vector<PairId>& list, const Tables& tables);

  QueryCulling culling_;
  Clock clock_;
  std::vector<query::PairMemory> memories_;  ///< pair memories, if culling_.remember
  QueryQueue queue_;                         ///< pairs deferred in this step
  std::vector<PairId> batch_;
  std::vector<Scratch> scratch_;  ///< one for each thread
  std::unique_ptr<PairWorkers> workers_;
  int threads_{1};
};

}  // namespace abstand::scene
