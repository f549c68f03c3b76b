// Which pairs the next step of a scene looks at.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/id.hpp"
#include "core/scene/scene_pair.hpp"

namespace abstand::scene {

/// Collects objects that move and pairs that are to be looked at whatever has moved, until a step makes them
/// its work. One thread; allocates when objects and pairs are added only.
class PairUpdates {
 public:
  /// `capacity`: objects or pairs that the scene's own table has room for.
  void addObject(std::size_t capacity);
  void addPair(std::size_t capacity);

  void addMoved(ObjectId object);
  /// Each pair once; paused ones not at all.
  void enqueue(PairId id, Pair& pair);
  /// The work of step number `step`: what was enqueued and the pairs of everything that has moved, each once.
  void begin(long step, PairTable& pairs, const std::vector<std::vector<PairId>>& pairs_of);

  /// The work of the last step, in no order.
  const std::vector<PairId>& renewed() const { return renewed_; }
  /// The last step that renewed a pair which is named with this object.
  long lastUpdateStep(ObjectId id) const { return last_update_step_[id.index()]; }

 private:
  std::vector<ObjectId> moved_;  ///< since the last step
  std::vector<bool> has_moved_;
  std::vector<PairId> pending_, renewed_;
  std::vector<long> last_update_step_;  ///< of each object
};

}  // namespace abstand::scene
