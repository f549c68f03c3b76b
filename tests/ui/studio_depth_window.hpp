// A window with a depth recording, for tests.
#pragma once

#include <QAction>
#include <QDockWidget>
#include <cmath>

#include "app/depth/depth_clip.hpp"
#include "app/depth/open_session.hpp"
#include "app/scene_file/scene_description.hpp"
#include "app/studio/depth_pictures.hpp"
#include "tests/ui/studio_window.hpp"
#include "ui/model/playback.hpp"
#include "ui/panels/depth_panel.hpp"
#include "ui/panels/depth_view.hpp"

namespace abstand::studio {

inline constexpr double kRate = 15.0;  // Hz
inline constexpr double kEnd = 1.0;    // s

/// A clip of somebody who reaches, as a Kinect would see it.
inline void writeClip(const std::filesystem::path& into) {
  auto session = depth::openSession(
      scene_file::parseScene("abstand: 1\ndefaults: {voxel: 0.1, point: 0.1}\nhumans:\n  - {name: anna, "
                             "recording: {file: \"" +
                                 testing::projectFile("data/scenes/hug_reach.bvh").string() + "\"}}\n",
                             "scene.yaml"),
      {});
  depth::DepthClipOptions options;
  options.camera = {.width = 320, .height = 240, .fx = 290.0, .fy = 290.0, .cx = 159.5, .cy = 119.5};
  options.camera.X_WC = depth::usualView(*session);
  options.skin.emplace();
  options.rate = kRate;
  options.end = kEnd;
  OutputFolder out(into);
  depth::writeDepthClip(*session, options, out);
  out.commit();
}

struct StudioDepth : StudioWindow {
  void SetUp() override {
    clip = folder.path() / "clip";
    writeClip(clip);
    times = tracking::openDepthStream(clip)->times();
  }
  bool opensClip() {
    return opens([&] { window.openFile(QString::fromStdString(clip.string())); });
  }
  ui::DepthPanel& panel() { return *window.panels().depth; }
  QDockWidget* dock() { return window.findChild<QDockWidget*>("depth"); }
  void raise() {
    window.findChild<QAction*>("panel_depth")->trigger();
    window.pull();
  }
  bool waits() {
    return QTest::qWaitFor([&] { return panel().isOfMoment(); }, kLoadMs);
  }
  const ui::DepthPicture& shown() { return panel().view().picture(); }
  double at(std::size_t image) const { return times[image]; }
  bool goesTo(double t) {
    window.playback().seek(t);
    return QTest::qWaitFor([&] { return std::abs(window.moment().t - t) < 1e-9; }, kLoadMs) && waits();
  }
  std::filesystem::path clip;
  std::vector<double> times;  ///< s, of its images
};

}  // namespace abstand::studio
