#include "app/depth/open_session.hpp"

#include "app/depth/scene_things.hpp"

namespace abstand {

std::unique_ptr<Session> openSession(SceneDescription scene, SessionOptions options) {
  SessionOptions same;
  same.cache = options.cache;
  same.monitor = options.monitor;
  std::unique_ptr<RobotView> things;
  options.known = [&](double t, const DepthCamera& camera) {
    if (!things) things = std::make_unique<RobotView>(scene, same);
    return &things->at(t, camera);
  };
  return std::make_unique<Session>(scene, options);
}

}  // namespace abstand
