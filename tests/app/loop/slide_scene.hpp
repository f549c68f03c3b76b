// A scene whose closed loop is known: a ball on a slide, and another that comes.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <string>

#include "app/session/session.hpp"
#include "tests/support/paths.hpp"

namespace abstand::testing {

/// A slide along x of 2 kg that carries a ball of 5 cm at x = q, and another ball, the thing, at 0.6 m unless
/// `--poses` moves it.
class SlideScene {
 public:
  explicit SlideScene(const std::string& reaction, const std::string& poses = "",
                      const std::string& more = "") {
    folder_.write("slide.mech", R"(units
length m
angle degrees
end_units
mapping
dof 0 1
end_mapping
chain
frame 1 0 90 d 0
end_chain
limits
limit 1 -5 5 10 500
end_limits
inertia
body 1 2 0 0 0 0.002 0.002 0.002 0 0 0
end_inertia
)");
    folder_.write("go.csv", "t,q0\n0,0\n1,-0.3\n2,-0.6\n");
    folder_.write("come.csv", "t,q0\n0,0\n2,0.3\n");
    if (!poses.empty()) folder_.write("poses.csv", poses);
    scene_file::SceneDescription scene = scene_file::parseScene(
        "abstand: 1\n"
        "defaults: {voxel: 0.01, point: 0.01, stiffness: 1.0e6}\n"
        "mechanisms:\n"
        "  - name: slide\n"
        "    file: slide.mech\n"
        "    base: {rpy: [0, 0, 1.5707963267948966]}\n" +
            more + "    reaction: " + reaction +
            "\n"
            "    links: [{name: ball, frame: 1, shape: {sphere: {radius: 0.05}}}]\n"
            "objects:\n"
            "  - {name: thing, shape: {sphere: {radius: 0.05}}, pose: {xyz: [0.6, "
            "0, 0]}}\n",
        folder_.path() / "scene.yaml");
    session::SessionOptions options;
    options.threads = 1;
    options.cache = false;
    if (!poses.empty()) options.poses = folder_.path() / "poses.csv";
    session = std::make_unique<session::Session>(std::move(scene), options);
  }

  std::unique_ptr<session::Session> session;

 private:
  ScratchFolder folder_;
};

/// Poses of the thing every millisecond for 3 s.
inline std::string thingAt(const std::function<double(double)>& x) {
  std::string csv =
      "t,thing.r00,thing.r01,thing.r02,thing.tx,thing.r10,thing.r11,thing.r12,thing.ty,thing.r20,thing.r21,"
      "thing.r22,thing.tz\n";
  for (int i = 0; i <= 3000; ++i)
    csv += std::to_string(i * 1e-3) + ",1,0,0," + std::to_string(x(i * 1e-3)) + ",0,1,0,0,0,0,1,0\n";
  return csv;
}

/// From 0.6 m at 0.5 m/s until it is at `to`, and stays.
inline std::string thingComesTo(double to) {
  return thingAt([to](double t) { return std::max(to, 0.6 - 0.5 * t); });
}

/// A robot that has a reaction and no masses, in `folder`.
inline scene_file::SceneDescription sceneWithoutMasses(const ScratchFolder& folder) {
  folder.write("m.mech", "mapping\ndof 0 1\nend_mapping\nchain\nframe 1 0 0 0 theta\nend_chain\n");
  return scene_file::parseScene(
      "abstand: 1\nmechanisms:\n  - name: m\n    file: m.mech\n    reaction: {}\n"
      "    links: [{name: l, frame: 1, shape: {sphere: {radius: 0.05}}}]\n",
      folder.path() / "scene.yaml");
}

}  // namespace abstand::testing
