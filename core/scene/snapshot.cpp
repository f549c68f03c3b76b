#include "core/scene/snapshot.hpp"

namespace abstand {

void capture(const Scene& scene, SceneSnapshot& snapshot) {
  const auto& objects = scene.objects();
  const auto& pairs = scene.pairs();
  snapshot.objects.resize(objects.size());
  snapshot.pairs.resize(pairs.size());
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const Object& o = objects[i];
    snapshot.objects[i] = {o.X_WB,    o.pose_state,  o.p_WCom(), o.velocity,
                           o.contact, o.spec.margin, o.colliding};
  }
  snapshot.nearest_pair = -1;
  double nearest = kInfinity;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    snapshot.pairs[i] = {pairs[i].result, pairs[i].options.margin};
    if (pairs[i].result.distance < nearest) {
      nearest = pairs[i].result.distance;
      snapshot.nearest_pair = static_cast<int>(i);
    }
  }
}

}  // namespace abstand
