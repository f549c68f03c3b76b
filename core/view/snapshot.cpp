#include "core/view/snapshot.hpp"

namespace abstand::view {

void capture(const scene::Scene& scene, SceneSnapshot& snapshot) {
  const auto& objects = scene.objects();
  const auto& pairs = scene.pairs();
  const bool first = snapshot.captured < 0 || snapshot.pairs.size() != pairs.size();
  snapshot.objects.resize(objects.size());
  snapshot.pairs.resize(pairs.size());
  const auto copy = [&](std::size_t i) {
    snapshot.pairs[i] = {pairs[i].result, pairs[i].options.margin, pairs[i].paused};
  };
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const scene::Object& o = objects[i];
    snapshot.objects[i] = {o.X_WB,    o.pose_state,  o.p_WCom(),  o.velocity,
                           o.contact, o.spec.margin, o.colliding, o.pose_uncertainty};
    const ObjectId id(static_cast<std::uint32_t>(i));
    if (!first && scene.lastUpdateStep(id) > snapshot.captured)
      for (const PairId pair : scene.pairsOf(id)) copy(pair.index());
  }
  if (first)
    for (std::size_t i = 0; i < pairs.size(); ++i) copy(i);
  const auto nearest = scene.nearest();
  snapshot.nearest_pair = nearest ? static_cast<int>(nearest->index()) : -1;
  snapshot.work = scene.counts();
  snapshot.captured = scene.steps();
}

}  // namespace abstand::view
