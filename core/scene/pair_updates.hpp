// Selects the pairs that the next step of a scene updates.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/id.hpp"
#include "core/scene/scene_pair.hpp"

namespace abstand::scene {

/// Collects moved objects and explicitly enqueued pairs; the next step updates them. One thread; allocates
/// only when objects and pairs are added.
class PairUpdates {
 public:
  /// `capacity`: number of objects or pairs that the scene's own table has room for.
  void addObject(std::size_t capacity);
  void addPair(std::size_t capacity);

  void addMoved(ObjectId object);
  /// Enqueues a pair once; ignored if it is paused.
  void enqueue(PairId id, Pair& pair);
  /// Work list of step number `step`: enqueued pairs and all pairs of moved objects, each once.
  void begin(long step, PairTable& pairs, const std::vector<std::vector<PairId>>& pairs_of);

  /// Work list of the last step, in no particular order.
  const std::vector<PairId>& updated() const { return updated_; }
  /// The last step that updated a pair indexed by this object.
  long lastUpdateStep(ObjectId id) const { return last_update_step_[id.index()]; }

 private:
  std::vector<ObjectId> moved_;  ///< since the last step
  std::vector<bool> has_moved_;
  std::vector<PairId> pending_, updated_;
  std::vector<long> last_update_step_;  ///< for each object
};

}  // namespace abstand::scene
