// Live mode: groups of pairs on threads of their own, as in the thesis.
#pragma once

#include <memory>
#include <vector>

#include "core/scene/scene.hpp"

namespace abstand::scene {

/// Each group of pairs runs on its own thread at its own rate: it reads the newest poses, queries its pairs
/// in sequence, and publishes the results [thesis 4.2.7, 4.2.8]. A paused group, or one without new poses,
/// sleeps.
///
/// One owner thread calls all functions. Poses and results are exchanged through triple buffers, so neither
/// side waits for the other (except stop(), which waits for the current cycle). A pair is in at most one
/// group. With QueryCulling::rest, queries of pairs whose bodies have speed bounds are skipped
/// (live_culling.hpp). Groups can be started, paused and stopped, and pairs added and removed, while others
/// run.
class PairThreads {
 public:
  /// Copies objects, pairs, current poses and culling options of the scene. Structures are shared; the scene
  /// need not outlive this object.
  explicit PairThreads(const Scene& scene);
  /// Stops all groups.
  ~PairThreads();

  using GroupIndex = std::size_t;
  /// Adds a group that does not run yet. Each pair gets a first result immediately, at the last published
  /// poses. Throws UsageError for a pair that is already in a group.
  GroupIndex addGroup(std::vector<PairId> pairs);
  /// Starts the thread, or continues after a pause. No effect for a running group.
  void start(GroupIndex group);
  void pause(GroupIndex group);  ///< after the current cycle, if any
  void stop(GroupIndex group);   ///< ends the thread; start() begins a new one
  /// Throws as addGroup(); takes effect in the thread's next cycle.
  void addPair(GroupIndex group, PairId pair);
  /// Its result and resultTime() stay as they were. Throws UsageError if it is not in this group.
  void removePair(GroupIndex group, PairId pair);

  /// Passes current poses, margins and time of the scene to all groups. Allocates nothing.
  void publishPoses(const Scene& scene);
  /// Copies the newest result of every pair that is or was in a group to `results` (size: pairs of the
  /// scene); returns the number of group cycles finished since the last call. Allocates nothing.
  long collect(std::vector<query::PairResult>& results);
  /// Time (s) of the poses of a pair's last collected result, the latest of the objects' times; minus
  /// infinity for a pair that was never in a group.
  double resultTime(PairId pair) const;
  /// The same for all pairs of the scene, for Scene::setResults().
  std::span<const double> resultTimes() const;
  /// True if the last collected result of every pair in a group belongs to the last published poses.
  bool upToDate() const;
  /// Numbers of queried and culled pairs, over all cycles of all groups.
  StepCounts counts() const;
  /// Cycles of a group since its thread was started.
  long cycles(GroupIndex group) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace abstand::scene
