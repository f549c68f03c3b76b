// The window as a whole, driven as a user does.
#include "ui/main_window.hpp"

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QProgressBar>
#include <QSettings>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>

#include "tests/ui/fake_session.hpp"
#include "ui/actions.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/recent_files.hpp"
#include "ui/panels/margin_panel.hpp"
#include "ui/panels/margin_row.hpp"
#include "ui/panels/pair_panel.hpp"
#include "ui/panels/status_panel.hpp"
#include "ui/panels/time_strip.hpp"
#include "ui/panels/timeline_panel.hpp"

namespace abstand::ui {
namespace {

constexpr int kWaitMs = 5000;
constexpr double kExact = 1e-9;  // s; a frame is 0.02 s

struct WindowTest : testing::Test {
  void SetUp() override {
    QSettings().clear();
    window.resize(1200, 800);
    window.setSession(&session);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, kWaitMs));
    session.log.clear();
  }
  void key(int k, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    // Shortcuts belong to the active window, and without a window manager nobody makes one active.
    QApplication::setActiveWindow(&window);
    QTest::keyClick(&window, static_cast<Qt::Key>(k), modifiers);
    window.pull();
  }
  void drop(const QStringList& paths) {
    QMimeData data;
    QList<QUrl> urls;
    for (const QString& path : paths) urls << QUrl::fromLocalFile(path);
    data.setUrls(urls);
    QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &enter);
    accepted = enter.isAccepted();
    if (!accepted) return;
    QDropEvent event(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &event);
  }
  FakeSession session;
  MainWindow window;
  bool accepted{false};
};

TEST_F(WindowTest, KeysMoveTheClockExactly) {
  const double frame = session.outline().frame_period;
  key(Qt::Key_Right);
  key(Qt::Key_Right);
  EXPECT_NEAR(session.time(), 2 * frame, kExact);
  key(Qt::Key_Left);
  EXPECT_NEAR(session.time(), frame, kExact);
  key(Qt::Key_Right, Qt::ShiftModifier);
  key(Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_NEAR(session.time(), 2.0 + frame, kExact);
  key(Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_NEAR(session.time(), 1.0 + frame, kExact);
  key(Qt::Key_End);
  EXPECT_EQ(session.time(), session.outline().end);
  key(Qt::Key_Right);
  EXPECT_EQ(session.time(), session.outline().end);
  key(Qt::Key_Home);
  EXPECT_EQ(session.time(), session.outline().start);
  EXPECT_EQ(window.playback().time(), session.time());
}

TEST_F(WindowTest, SpacePlaysAndPauses) {
  key(Qt::Key_Space);
  EXPECT_TRUE(session.playing());
  session.advance(0.1);
  window.pull();
  EXPECT_NEAR(window.playback().time(), session.time(), kExact);
  key(Qt::Key_Space);
  EXPECT_FALSE(session.playing());
}

TEST_F(WindowTest, KeysBelongToATextFieldThatHasTheFocus) {
  QLineEdit* box = window.pairPanel().filterBox();
  QApplication::setActiveWindow(&window);
  box->setFocus();
  ASSERT_TRUE(box->hasFocus());
  QTest::keyClicks(box, "c v");
  EXPECT_EQ(box->text(), "c v");
  EXPECT_TRUE(session.log.empty());
}

TEST_F(WindowTest, TheStripFollowsThePointer) {
  TimeStrip* strip = window.timelinePanel().strip();
  const int y = strip->height() / 2;
  QTest::mousePress(strip, Qt::LeftButton, {}, QPoint(strip->xOf(3.0), y));
  EXPECT_NEAR(session.time(), strip->timeAt(strip->xOf(3.0)), kExact);
  QMouseEvent move(QEvent::MouseMove, QPoint(strip->xOf(7.0), y), Qt::NoButton, Qt::LeftButton,
                   Qt::NoModifier);
  QApplication::sendEvent(strip, &move);
  EXPECT_NEAR(session.time(), strip->timeAt(strip->xOf(7.0)), kExact);
  EXPECT_EQ(window.playback().time(), session.time());
}

TEST_F(WindowTest, AMarginReachesTheSession) {
  const int hand = session.indexOf("operator/hand_left");
  window.marginPanel().row(hand)->findChild<QSlider*>()->setValue(123);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !session.log.empty(); }, kWaitMs));
  EXPECT_EQ(session.log, std::vector<std::string>{"margin " + std::to_string(hand) + " 0.123"});
}

TEST_F(WindowTest, DroppedFilesAreAskedForByTheirKind) {
  QSignalSpy scenes(&window, &MainWindow::openSceneRequested);
  QSignalSpy recordings(&window, &MainWindow::openRecordingRequested);
  drop({"/somewhere/walk.bvh", "/somewhere/cell.yaml"});
  EXPECT_TRUE(accepted);
  ASSERT_EQ(scenes.size(), 1);
  EXPECT_EQ(scenes[0][0].toString(), "/somewhere/cell.yaml");
  ASSERT_EQ(recordings.size(), 1);
  EXPECT_EQ(recordings[0][0].toString(), "/somewhere/walk.bvh");
  drop({"/somewhere/picture.gif"});
  EXPECT_FALSE(accepted);
  EXPECT_EQ(scenes.size(), 1);
}

TEST_F(WindowTest, RecentScenesAreRememberedNewestFirst) {
  for (int i = 0; i < kRecentFiles + 2; ++i) rememberFile(QStringLiteral("/scenes/%1.yaml").arg(i));
  rememberFile("/scenes/4.yaml");
  EXPECT_EQ(recentFiles(), (QStringList{"/scenes/4.yaml", "/scenes/6.yaml", "/scenes/5.yaml",
                                        "/scenes/3.yaml", "/scenes/2.yaml"}));
}

TEST_F(WindowTest, LayoutAndViewOutliveTheWindow) {
  auto* plots = window.findChild<QDockWidget*>("plots");
  plots->hide();
  window.actions()[ActionId::kVelocities]->setChecked(true);
  window.actions()[ActionId::kFloor]->setChecked(false);
  window.close();
  MainWindow next;
  next.show();
  EXPECT_FALSE(next.findChild<QDockWidget*>("plots")->isVisible());
  EXPECT_TRUE(next.findChild<QDockWidget*>("pairs")->isVisible());
  EXPECT_TRUE(next.actions()[ActionId::kVelocities]->isChecked());
  EXPECT_FALSE(next.actions()[ActionId::kFloor]->isChecked());
  next.actions()[ActionId::kResetLayout]->trigger();
  EXPECT_TRUE(next.findChild<QDockWidget*>("plots")->isVisible());
}

TEST_F(WindowTest, TheStatusBarSaysWhatWasLeftOut) {
  const auto* label = window.findChild<QLabel*>("left_out");
  ASSERT_TRUE(label);
  const QString pairs = QString::number(session.outline().pairs.size());
  const auto shows = [&](const QString& text) {
    window.pull();
    return QTest::qWaitFor([&] { return label->text() == text; }, kWaitMs);
  };
  session.setWork({.checked = 12, .rested = 34, .beyond = 5, .put_off = 6, .longest_wait = 7});
  EXPECT_TRUE(shows("Checked 12 of " + pairs + ", rested 34, beyond 5, late 6"))
      << label->text().toStdString();
  EXPECT_TRUE(label->isVisible());
  for (const char* part : {"checked: 12\n", "rested, ", ": 34\n", "horizon: 5\n", "6 (longest: 7 cycles)"})
    EXPECT_TRUE(label->toolTip().contains(part)) << part << " in " << label->toolTip().toStdString();
  const int still = static_cast<int>(session.outline().pairs.size()) - 12 - 34 - 5 - 6;
  EXPECT_TRUE(label->toolTip().contains(": " + QString::number(still) + "\n"));
  // Nothing left out, nothing said of it.
  session.setWork({.checked = 3});
  EXPECT_TRUE(shows("Checked 3 of " + pairs)) << label->text().toStdString();
  window.setSession(nullptr);
  EXPECT_TRUE(label->text().isEmpty());
}

TEST_F(WindowTest, OpeningASceneIsShown) {
  const auto* text = window.findChild<QLabel*>("opening");
  const auto* bar = window.findChild<QProgressBar*>();
  ASSERT_TRUE(text && bar);
  EXPECT_FALSE(bar->isVisible());
  window.showOpening({});
  EXPECT_TRUE(bar->isVisible());
  EXPECT_EQ(bar->maximum(), 0);  // busy, no share known
  EXPECT_EQ(text->text(), "Reading files");
  window.showOpening({.begun = 3, .all = 16, .name = "link3", .building = false, .fraction = 0.25});
  EXPECT_EQ(text->text(), "Structure 3 of 16: link3");
  EXPECT_EQ(4 * bar->value(), bar->maximum());
  window.showOpening({.begun = 4, .all = 16, .name = "link4", .building = true, .fraction = 0.5});
  EXPECT_EQ(text->text(), "Building structure 4 of 16: link4");
  EXPECT_EQ(2 * bar->value(), bar->maximum());
  window.hideOpening();
  EXPECT_FALSE(bar->isVisible());
  EXPECT_FALSE(text->isVisible());
}

TEST_F(WindowTest, ASessionMayComeAndGo) {
  window.setSession(nullptr);
  window.pull();
  key(Qt::Key_Right);
  EXPECT_TRUE(session.log.empty());
  FakeSession other;
  window.setSession(&other);
  key(Qt::Key_Right);
  EXPECT_NEAR(other.time(), other.outline().frame_period, kExact);
  window.setSession(nullptr);
}

}  // namespace
}  // namespace abstand::ui
