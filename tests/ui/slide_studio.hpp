// A window that shows a ball which comes at a person.
#pragma once

#include <gtest/gtest.h>

#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <memory>

#include "app/studio/studio.hpp"
#include "tests/app/tune/slide_scene.hpp"
#include "ui/model/recording_review.hpp"

namespace abstand::studio {

/// With settings and a structure cache of its own; nothing is open at first.
struct SlideStudio : ::testing::Test {
  static constexpr int kLimitMs = 240000;  // nothing takes so long, under a sanitizer either

  explicit SlideStudio(const testing::SlideSpeeds& speeds) {
    QSettings().clear();
    qputenv("ABSTAND_CACHE", (folder.path() / "cache").c_str());
    scene = testing::writeSlide(folder, speeds);
    window.resize(1400, 1000);
    window.show();
    studio = std::make_unique<Studio>(window);
  }
  void open() {
    QSignalSpy ready(studio.get(), &Studio::ready);
    studio->openScene(QString::fromStdString(scene.string()), {}, 0.0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !ready.isEmpty(); }, kLimitMs));
  }
  bool analysed() {
    return QTest::qWaitFor([this] { return window.review().state() == view::AnalysisNews::State::kDone; },
                           kLimitMs);
  }

  testing::ScratchFolder folder;
  std::filesystem::path scene;
  ui::MainWindow window;
  std::unique_ptr<Studio> studio;
};

}  // namespace abstand::studio
