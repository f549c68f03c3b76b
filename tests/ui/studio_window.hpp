// A window with real sessions of a small scene, for tests.
#pragma once

#include <gtest/gtest.h>

#include <QSettings>
#include <QSignalSpy>
#include <QTest>

#include "app/studio/studio.hpp"
#include "humanmodel/human_model.hpp"
#include "tests/support/paths.hpp"
#include "tracking/table/skeleton_csv.hpp"
#include "ui/document/document.hpp"
#include "ui/project_commands.hpp"
#include "ui/viewport/viewport.hpp"

namespace abstand::studio {

/// Three files in a folder: a scene with one person and a wall, and two recordings for the person.
struct StudioWindow : ::testing::Test {
  static constexpr int kLoadMs = 120000;

  StudioWindow() {
    QSettings().clear();
    folder.write("walk.csv", recording(0.0));
    folder.write("turn.csv", recording(0.3));
    folder.write(
        "scene.yaml",
        "abstand: 1\ndefaults: {voxel: 0.1, point: 0.1, margin: 0.02}\n"
        "humans:\n  - {name: anna, recording: {file: walk.csv}}\n"
        "objects:\n  - {name: wall, shape: {cuboid: {size: [0.2, 1, 1]}}, pose: {xyz: [-1, 0, 1]}}\n");
    window.resize(900, 700);
    window.show();
  }
  static std::string recording(double x) {
    std::string text = "t,pelvis.x,pelvis.y,pelvis.z,neck.x,neck.y,neck.z\n";
    for (int i = 0; i < 20; ++i) {
      const std::string at = std::to_string(x + 0.01 * i);
      text += std::to_string(0.1 * i) + "," + at + ",0,1," + at + ",0,1.5\n";
    }
    return text;
  }
  /// Of a person who stands upright at x (m) and goes on along it.
  void writeUpright(const char* name, double x) const {
    tracking::Recording recording;
    for (int i = 0; i < 20; ++i) {
      humanmodel::SkeletonFrame frame = humanmodel::makeHuman({}).rest;
      frame.t = 0.1 * i;
      for (auto& p : frame.p) p.x() += x + 0.01 * i;
      recording.frames.push_back(frame);
    }
    tracking::writeSkeletonCsv(folder.path() / name, recording);
  }
  QString in(const char* name) const { return QString::fromStdString((folder.path() / name).string()); }
  const ui::Work& work() const { return window.document().work(); }
  /// True when `ask` has led to a session in the window.
  template <class Ask>
  bool opens(Ask ask) {
    const QSignalSpy ready(&studio, &Studio::ready);
    const QSignalSpy failed(&studio, &Studio::failed);
    ask();
    const bool ended = QTest::qWaitFor([&] { return ready.size() + failed.size() > 0; }, kLoadMs);
    if (!failed.isEmpty()) problem = failed[0][0].toString().toStdString();
    return ended && !ready.isEmpty();
  }

  testing::ScratchFolder folder;
  ui::MainWindow window;
  Studio studio{window};
  std::string problem;
};

}  // namespace abstand::studio
