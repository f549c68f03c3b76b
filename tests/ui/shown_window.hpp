// A window that shows a made-up session, for tests of what can be seen.
#pragma once

#include <gtest/gtest.h>

#include <QSettings>
#include <QTest>

#include "tests/ui/fake_session.hpp"
#include "ui/main_window.hpp"
#include "ui/viewport/opengl.hpp"
#include "ui/viewport/viewport.hpp"

namespace abstand::ui {

/// Skips the test where there is no OpenGL.
struct ShownWindow : ::testing::Test {
  static constexpr int kWaitMs = 10000;

  void SetUp() override {
    if (!openGlInfo().available) GTEST_SKIP() << "no OpenGL 3.2 here";
    QSettings().clear();
    window.resize(1200, 800);
    window.setSession(&session);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, kWaitMs));
    ASSERT_TRUE(QTest::qWaitFor([this] { return window.viewport().framesDrawn() > 0; }, kWaitMs));
  }

  FakeSession session;
  MainWindow window;
};

}  // namespace abstand::ui
