// Where all objects are at one moment.
#pragma once

#include <vector>

#include "core/math/transform.hpp"
#include "core/scene/scene_object.hpp"

namespace abstand::view {

struct ObjectPose {
  Transform X_WB{Transform::Identity()};
  scene::PoseState state{scene::PoseState::kFresh};
};

/// In the order of the scene.
struct MomentPoses {
  double t{0.0};  ///< s
  std::vector<ObjectPose> objects;
};

}  // namespace abstand::view
