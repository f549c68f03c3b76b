#include "app/depth/open_session.hpp"

#include "app/depth/scene_things.hpp"

namespace abstand::depth {

std::unique_ptr<session::Session> openSession(scene_file::SceneDescription scene,
                                              session::SessionOptions options) {
  session::SessionOptions same;
  same.cache = options.cache;
  same.monitor = options.monitor;
  std::unique_ptr<RobotView> things;
  const auto view = [&]() -> RobotView& {
    if (!things) things = std::make_unique<RobotView>(scene, same);
    return *things;
  };
  options.known.known = [&](double t, const tracking::DepthCamera& camera) { return &view().at(t, camera); };
  options.known.robots = [&](double t, const tracking::DepthCamera& camera) {
    return view().robotsAt(t, camera);
  };
  return std::make_unique<session::Session>(scene, options);
}

}  // namespace abstand::depth
