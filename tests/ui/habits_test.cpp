// Keys, focus and sizes as people expect them.
#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QSlider>
#include <QStatusBar>
#include <QToolButton>
#include <array>
#include <cstdio>

#include "tests/ui/shown_window.hpp"
#include "ui/model/time_axis.hpp"
#include "ui/panels/help_dialogs.hpp"
#include "ui/panels/margin_panel.hpp"
#include "ui/panels/margin_row.hpp"
#include "ui/panels/scene_tree_panel.hpp"
#include "ui/panels/status_panel.hpp"
#include "ui/style/actions.hpp"
#include "ui/style/elided_label.hpp"

namespace abstand::ui {
namespace habits_test {

struct KeyboardTest : ShownWindow {
  void SetUp() override {
    ShownWindow::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    session.log.clear();
    QApplication::setActiveWindow(&window);
  }
  bool focus(QWidget* widget) {
    widget->setFocus(Qt::TabFocusReason);
    return QTest::qWaitFor([&] { return widget->hasFocus(); }, kWaitMs);
  }
};

TEST_F(KeyboardTest, ArrowsMoveFocusedSlider) {
  auto* slider = window.panels().margins->row(session.indexOf("operator/hand_left"))->findChild<QSlider*>();
  ASSERT_TRUE(focus(slider));
  const int before = slider->value();
  QTest::keyClick(slider, Qt::Key_Right);
  EXPECT_EQ(slider->value(), before + 1);
  QTest::keyClick(slider, Qt::Key_End);
  EXPECT_EQ(slider->value(), slider->maximum());
  QTest::keyClick(slider, Qt::Key_Home);
  EXPECT_EQ(slider->value(), slider->minimum());
  EXPECT_EQ(session.time(), 0.0) << "the clock stands";
  QTest::keyClick(slider, Qt::Key_Space);
  EXPECT_TRUE(session.playing()) << "what a slider has no use for stays a shortcut";
}

TEST_F(KeyboardTest, TreeFoldsAndTicksByKeys) {
  auto* tree = window.findChild<SceneTreePanel*>();
  ASSERT_TRUE(focus(tree));
  const QModelIndex arm = tree->model()->index(0, 0);
  tree->setCurrentIndex(arm);
  QTest::keyClick(tree, Qt::Key_Left);
  EXPECT_FALSE(tree->isExpanded(arm));
  QTest::keyClick(tree, Qt::Key_Right);
  EXPECT_TRUE(tree->isExpanded(arm));
  QTest::keyClick(tree, Qt::Key_Space);
  EXPECT_EQ(arm.data(Qt::CheckStateRole).toInt(), Qt::Unchecked);
  EXPECT_FALSE(session.playing());
  EXPECT_EQ(session.time(), 0.0);
}

TEST_F(KeyboardTest, CameraMovesByKeys) {
  const auto moves = [&](int key, Qt::KeyboardModifiers modifiers) {
    const CameraView before = window.viewport().cameraView();
    QTest::keyClick(&window, static_cast<Qt::Key>(key), modifiers);
    return !(window.viewport().cameraView() == before);
  };
  for (const int key : {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down}) {
    EXPECT_TRUE(moves(key, Qt::ControlModifier)) << key;
    EXPECT_TRUE(moves(key, Qt::ControlModifier | Qt::ShiftModifier)) << key;
  }
  const double distance = window.viewport().cameraView().distance;
  EXPECT_TRUE(moves(Qt::Key_Plus, Qt::ControlModifier));
  EXPECT_LT(window.viewport().cameraView().distance, distance);
  EXPECT_TRUE(moves(Qt::Key_Minus, Qt::ControlModifier));
  EXPECT_NEAR(window.viewport().cameraView().distance, distance, 1e-12);
  EXPECT_EQ(session.time(), 0.0);
}

TEST_F(KeyboardTest, ShortcutPageListsMouseActions) {
  EXPECT_FALSE(window.windowIcon().isNull());
  EXPECT_TRUE(shortcutPage(window.actions()).contains("Double click"));
}

TEST_F(KeyboardTest, AltAndDragScrubsInView) {
  QWidget* gl = window.viewport().childAt(10, 10);
  ASSERT_NE(gl, nullptr);
  const CameraView camera = window.viewport().cameraView();
  const auto send = [&](QEvent::Type type, int x, Qt::MouseButton button) {
    QMouseEvent event(type, QPointF(x, 40), button, Qt::LeftButton, Qt::AltModifier);
    QCoreApplication::sendEvent(gl, &event);
  };
  const double before = session.time();
  send(QEvent::MouseButtonPress, 20, Qt::LeftButton);
  send(QEvent::MouseMove, 70, Qt::NoButton);
  send(QEvent::MouseMove, 120, Qt::NoButton);
  const TimeRange& shown = window.timeAxis().view();
  EXPECT_NEAR(session.time(), before + 100.0 / window.viewport().width() * shown.length(), 1e-9);
  EXPECT_TRUE(window.viewport().cameraView() == camera);
}

TEST_F(KeyboardTest, LargeWindowHasLargerPanels) {
  const auto sizes = [this](const QSize& size) {
    window.resize(size);
    window.actions()[ActionId::kResetLayout]->trigger();
    QCoreApplication::processEvents();
    const auto dock = [this](const char* name) { return window.findChild<QDockWidget*>(name)->size(); };
    return std::array{dock("timeline").height(), dock("pairs").height(), dock("plots").width()};
  };
  const auto usual = sizes({1280, 800}), large = sizes({2880, 1620});
  for (std::size_t i = 0; i < usual.size(); ++i) EXPECT_GT(large[i], usual[i] + 40) << i;
  // The 3D view keeps most of the room.
  EXPECT_GT(window.viewport().height(), 1620 / 2);
  EXPECT_GT(window.viewport().width(), 2880 / 2);
}

TEST_F(KeyboardTest, NextStartHasSizeOfLast) {
  const QSize size(1130, 760);
  window.resize(size);
  QCoreApplication::processEvents();
  ASSERT_TRUE(window.close());
  const MainWindow next;
  EXPECT_EQ(next.size(), size);
}

TEST_F(KeyboardTest, FitsSmallScreen) {
  const QSize small(1024, 700);
  for (const int round : {0, 1}) {
    window.resize(small);
    EXPECT_EQ(window.size(), small) << round;
    EXPECT_LE(window.minimumSizeHint().width(), small.width());
    for (const auto* dock : window.findChildren<QDockWidget*>())
      if (window.minimumSizeHint().width() > small.width())
        std::printf("%s needs %d px\n", qPrintable(dock->objectName()), dock->minimumSizeHint().width());
    EXPECT_LE(window.minimumSizeHint().height(), small.height());
    // With every text as long as it gets.
    session.setWork(
        {.checked = 123456, .rested = 34567, .beyond = 51234, .deferred = 6123, .longest_wait = 7});
    for (auto* label : window.statusBar()->findChildren<ElidedLabel*>())
      label->setText(label->text() + QString(80, 'x'));
    window.pull();
  }
}

TEST_F(KeyboardTest, PanelActionRaisesThenHides) {
  auto* dock = window.findChild<QDockWidget*>(QStringLiteral("curve"));
  ASSERT_NE(dock, nullptr);
  QAction* action = nullptr;
  for (const auto& entry : window.actions().all())
    if (entry.action->shortcut() == QKeySequence(QStringLiteral("Ctrl+Shift+5"))) action = entry.action;
  ASSERT_NE(action, nullptr);
  const auto in_front = [&] { return dock->isVisible() && !dock->visibleRegion().isEmpty(); };
  EXPECT_FALSE(in_front()) << "it starts behind the pairs";
  EXPECT_TRUE(action->isChecked());
  for (int round = 0; round < 2; ++round) {
    action->trigger();
    EXPECT_TRUE(QTest::qWaitFor(in_front, kWaitMs));
    EXPECT_TRUE(action->isChecked());
    action->trigger();
    EXPECT_TRUE(dock->isHidden());
    EXPECT_FALSE(action->isChecked());
  }
}

TEST_F(KeyboardTest, OpeningCanBeCancelled) {
  QSignalSpy cancelled(&window, &MainWindow::cancelRequested);
  auto* cancel = window.findChild<QToolButton*>("cancel_opening");
  ASSERT_TRUE(cancel);
  EXPECT_FALSE(cancel->isVisible());
  window.showOpening({.images_done = 12, .images = 300});
  EXPECT_EQ(window.findChild<QLabel*>("opening")->text(), "Finding the person: image 12 of 300");
  ASSERT_TRUE(cancel->isVisible());
  cancel->click();
  EXPECT_EQ(cancelled.size(), 1);
  window.hideOpening();
  EXPECT_FALSE(cancel->isVisible());
}

}  // namespace habits_test
}  // namespace abstand::ui
