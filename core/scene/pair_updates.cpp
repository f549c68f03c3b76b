#include "core/scene/pair_updates.hpp"

#include <utility>

namespace abstand::scene {

void PairUpdates::addObject(std::size_t capacity) {
  has_moved_.push_back(false);
  last_update_step_.push_back(0);
  moved_.reserve(capacity);
}

void PairUpdates::addPair(std::size_t capacity) {
  pending_.reserve(capacity);
  updated_.reserve(capacity);
}

void PairUpdates::addMoved(ObjectId object) {
  if (has_moved_[object.index()]) return;
  has_moved_[object.index()] = true;
  moved_.push_back(object);
}

void PairUpdates::enqueue(PairId id, Pair& pair) {
  if (pair.queued || pair.paused) return;
  pair.queued = true;
  pending_.push_back(id);
}

void PairUpdates::begin(long step, PairTable& pairs, const std::vector<std::vector<PairId>>& pairs_of) {
  for (const PairId id : pending_) last_update_step_[pairs[id.index()].a.index()] = step;
  for (const ObjectId object : moved_) {
    const auto& list = pairs_of[object.index()];
    for (std::size_t i = 0; i < list.size(); ++i) {
      prefetchAhead(pairs, list, i);
      enqueue(list[i], pairs[list[i].index()]);
    }
    has_moved_[object.index()] = false;
    last_update_step_[object.index()] = step;
  }
  moved_.clear();
  std::swap(updated_, pending_);
  pending_.clear();
}

}  // namespace abstand::scene
