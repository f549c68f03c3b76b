// A served scene of a ball that moves, and its viewers.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <thread>

#include "app/serve/served_scene.hpp"
#include "app/viewer/viewer_host.hpp"
#include "app/viewer/viewer_link.hpp"
#include "tests/app/serve/joint_packet.hpp"
#include "tests/support/paths.hpp"

namespace abstand::testing {

/// A ball on a vertical slide (q is its height) over a plate whose top lies at z = 0.
inline constexpr const char* kServedBall = R"(abstand: 1
defaults: {voxel: 0.02, point: 0.02}
mechanisms:
  - name: slide
    file: slide.mech
    q: [1]
    links: [{name: ball, frame: 1, margin: 0.07, shape: {sphere: {radius: 0.1}}}]
objects:
  - {name: plate, shape: {cuboid: {size: [1, 1, 0.2]}}, pose: {xyz: [0, 0, -0.1]}}
)";
inline constexpr const char* kServedSlide = "chain\n    frame   1   0      0          d    0\nend_chain\n";
// s beyond which something does not come at all, however busy the machine is.
inline constexpr double kAllowance = 30.0;

/// A served scene whose viewers connect to `host`.
struct ServedBall {
  ScratchFolder folder;
  std::filesystem::path file;
  std::unique_ptr<serve::ServedScene> scene;
  std::unique_ptr<viewer::ViewerHost> host;
  serve::Packet packet;
  double begin{viewer::steadySeconds()};
  std::uint64_t cycles{0};

  ServedBall() { open({}); }
  void open(const viewer::HostOptions& options) {
    host.reset();
    folder.write("slide.mech", kServedSlide);
    session::SessionOptions session;
    session.threads = 1;
    session.cache = false;
    session.remember = true;
    file = folder.write("scene.yaml", kServedBall);
    scene = std::make_unique<serve::ServedScene>(
        std::make_unique<session::Session>(scene_file::parseScene(kServedBall, file), session),
        serve::ServedOptions{serve::usualReaction(), 4});
    packet = serve::makePacket(scene->format());
    host = std::make_unique<viewer::ViewerHost>(serve::parseAddress("127.0.0.1:0", "address"),
                                                viewer::cardOf(*scene), *scene, options);
  }
  double now() const { return viewer::steadySeconds() - begin; }
  /// A cycle with the ball at this height, shown to the viewers.
  void cycle(double height) {
    const double t = now();
    serve::setJoint(packet, height, t, false);
    scene->take(packet, t);
    scene->cycle(t);
    host->look(now(), ++cycles, *scene);
  }
  /// True when `done`, while the ball rises from 0.2 m.
  template <class Done>
  bool runUntil(Done done) {
    for (const double until = now() + kAllowance; now() < until;) {
      if (done()) return true;
      cycle(0.2 + 0.001 * static_cast<double>(cycles % 500));
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return done();
  }
};

}  // namespace abstand::testing
