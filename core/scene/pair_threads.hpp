// Live mode: groups of pairs on their own threads, as in the thesis.
#pragma once

#include <memory>
#include <vector>

#include "core/scene/scene.hpp"

namespace abstand {

/// Each group of pairs runs on a thread of its own, at its own pace: it takes the newest poses, queries its
/// pairs one after the other, and publishes the results [thesis 4.2.7, 4.2.8]. Poses are handed in and
/// results are taken out by one owner thread, through triple buffers; nobody waits for anybody. Groups can be
/// started, paused and stopped, and pairs added and removed, while the others run.
class PairThreads {
 public:
  /// Objects are those of the scene at this moment; its structures must outlive this object.
  explicit PairThreads(const Scene& scene);
  ~PairThreads();

  using GroupIndex = std::size_t;
  GroupIndex addGroup(std::vector<PairId> pairs);
  void start(GroupIndex group);
  void pause(GroupIndex group);
  void stop(GroupIndex group);
  void addPair(GroupIndex group, PairId pair);     ///< takes effect at the group's next cycle
  void removePair(GroupIndex group, PairId pair);  ///< its result stays as it was, flagged by result age

  /// Hands the present poses, margins and time of the scene to all groups.
  void publishPoses(const Scene& scene);
  /// Copies the newest results of all groups into `results` (size: pairs of the scene); returns the number of
  /// group cycles finished since the last call.
  long collect(std::vector<PairResult>& results);
  /// Cycles that a group has run since it was started.
  long cycles(GroupIndex group) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace abstand
