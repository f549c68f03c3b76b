// Live mode: groups of pairs on their own threads, as in the thesis.
#pragma once

#include <memory>
#include <vector>

#include "core/scene/scene.hpp"

namespace abstand::scene {

/// Each group of pairs runs on a thread of its own, at its own pace: it takes the newest poses, queries its
/// pairs one after the other, and publishes the results [thesis 4.2.7, 4.2.8]. A group without new poses, or
/// paused, sleeps and takes no processor time.
///
/// One owner thread calls all functions; poses are handed in and results taken out through triple buffers, so
/// that neither side waits for the other (but stop(), which waits for the group's cycle under way). A pair is
/// in one group at most. With QueryCulling::rest, pairs of bodies with a bound on their speed rest
/// (live_culling.hpp). Groups can be started, paused and stopped, and pairs added and removed, while the
/// others run.
class PairThreads {
 public:
  /// Objects and pairs are those of the scene at this moment, at their present poses; how long pairs rest,
  /// too. Structures are shared, the scene itself may go.
  explicit PairThreads(const Scene& scene);
  /// Stops all groups.
  ~PairThreads();

  using GroupIndex = std::size_t;
  /// The group does not run yet. Each pair gets a first result at once, at the poses published last. Throws
  /// UsageError for a pair that is in a group already.
  GroupIndex addGroup(std::vector<PairId> pairs);
  /// Begins a thread, or goes on after a pause. Nothing for a group that runs.
  void start(GroupIndex group);
  void pause(GroupIndex group);  ///< after the cycle under way, if there is one
  void stop(GroupIndex group);   ///< ends the thread; start() begins a new one
  /// As in addGroup; the thread takes it up in its next cycle.
  void addPair(GroupIndex group, PairId pair);
  /// Its result stays as it was, and its resultTime() too. Throws UsageError when it is not in this group.
  void removePair(GroupIndex group, PairId pair);

  /// Hands the present poses, margins and time of the scene to all groups. Allocates nothing.
  void publishPoses(const Scene& scene);
  /// Copies the newest result of every pair that is or was in a group into `results` (size: pairs of the
  /// scene); returns the number of group cycles finished since the last call. Allocates nothing.
  long collect(std::vector<query::PairResult>& results);
  /// Time of the poses that a pair's last collected result belongs to (s, the latest of the objects' times);
  /// minus infinity for a pair that was never in a group.
  double resultTime(PairId pair) const;
  /// The same of all pairs of the scene, as Scene::take() wants them.
  std::span<const double> resultTimes() const;
  /// Whether the last collected result of every pair that is in a group belongs to the poses published last.
  bool upToDate() const;
  /// Pairs that were queried and that rested, over all cycles of all groups.
  StepCounts counts() const;
  /// Cycles that a group has run since its thread began.
  long cycles(GroupIndex group) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace abstand::scene
