// Bodies that wander about, for tests of what a scene may leave out.
#pragma once

#include <vector>

#include "core/scene/scene.hpp"

namespace abstand::testing {

/// Nine rods and boxes, some with margins, all pairs.
scene::Scene longBodies();

/// All objects of a scene drift about in a room of some metres, up to 3 mm and 0.02 rad a frame, and turn; a
/// third of them stands still at times, and now and then one jumps.
class Drift {
 public:
  explicit Drift(scene::Scene& scene);
  void frame(int number);

 private:
  scene::Scene& scene_;
  std::vector<Transform> X_;
};

}  // namespace abstand::testing
