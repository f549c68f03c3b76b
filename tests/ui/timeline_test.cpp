// The timeline and the events of a whole recording, driven as a user does.
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSlider>
#include <QTableView>
#include <QTest>
#include <QToolTip>
#include <QWheelEvent>

#include "tests/ui/fake_analysis.hpp"
#include "ui/main_window.hpp"
#include "ui/model/event_table_model.hpp"
#include "ui/model/event_text.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/selection.hpp"
#include "ui/panels/event_panel.hpp"
#include "ui/panels/lane_view.hpp"
#include "ui/panels/margin_panel.hpp"
#include "ui/panels/margin_row.hpp"
#include "ui/panels/time_minimap.hpp"
#include "ui/panels/time_strip.hpp"
#include "ui/panels/timeline_panel.hpp"
#include "ui/style/actions.hpp"

namespace abstand::ui {
namespace timeline_test {

constexpr int kLimitMs = 60000;  // nothing takes so long

struct TimelineTest : ::testing::Test {
  void SetUp() override {
    QSettings().clear();
    session.recording = &analysis;
    window.resize(1400, 1000);
    window.setSession(&session);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, kLimitMs));
    analysis.runAll();
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.review().state() == view::AnalysisNews::State::kDone; },
                                kLimitMs));
    session.log.clear();
  }
  void key(int k, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QApplication::setActiveWindow(&window);
    QTest::keyClick(&window, static_cast<Qt::Key>(k), modifiers);
    window.pull();
  }
  LaneView& lanes() { return *window.panels().timeline->laneView(); }
  long stops() { return window.review().review().outcome.stops; }
  void click(int lane, double t) {
    QTest::mouseClick(lanes().viewport(), Qt::LeftButton, {},
                      QPoint(lanes().xOf(t), lane * LaneView::kLaneHeight + LaneView::kLaneHeight / 2));
  }

  FakeSession session;
  FakeAnalysis analysis{session.outline(), [this](std::size_t part, std::size_t frame) {
                          return valley(part, analysis.t(frame));
                        }};
  MainWindow window;
};

TEST_F(TimelineTest, ClickOnLaneGoesToMoment) {
  EXPECT_TRUE(lanes().isVisible());
  ASSERT_EQ(lanes().lanes(), 14);
  EXPECT_EQ(lanes().laneAt(0), 0);
  click(1, 4.0);
  EXPECT_NEAR(session.time(), 4.0, 12.0 / lanes().viewport()->width());
  const int head = session.indexOf("operator/head"), link = session.indexOf("arm/link0");
  EXPECT_EQ(window.selection().objects(), (std::vector<int>{std::min(head, link), std::max(head, link)}));
  EXPECT_GE(window.selection().pair(), 0);
}

TEST_F(TimelineTest, DraggingMarginUpdatesSpansAndSentence) {
  const int hand = session.indexOf("operator/hand_left");
  const auto* sentence = window.panels().timeline->whatIf();
  EXPECT_TRUE(sentence->isVisible());
  const auto inside = [&] {
    const std::vector<bool>& marks = lanes().row(6).inside;
    return std::count(marks.begin(), marks.end(), true);
  };
  auto* slider = window.panels().margins->row(hand)->findChild<QSlider*>();
  std::ptrdiff_t last = -1;
  for (const int margin : {0, 100, 200, 300}) {
    slider->setValue(margin);
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return window.review().marginOf(6, 0) == 0.01 + 1e-3 * margin; }, kLimitMs));
    QCoreApplication::processEvents();
    // Part 6 is nearest at 4 s with 80 mm and goes away at 0.5 m/s.
    const double half = std::max(0.0, (0.01 + 1e-3 * margin - 0.08) / 0.5);
    const double column = 12.0 / static_cast<double>(lanes().row(6).inside.size());
    EXPECT_NEAR(static_cast<double>(inside()) * column, 2.0 * half, 0.05) << margin;
    EXPECT_TRUE(last < 0 || inside() > last || inside() == 0);
    last = inside();
    EXPECT_TRUE(sentence->text().startsWith(QString::number(stops()) + " stops"))
        << sentence->text().toStdString();
  }
}

TEST_F(TimelineTest, KeysGoToEventsOfWholeRecording) {
  // Nothing has been played.
  const auto first = window.review().nextEvent(0.0);
  ASSERT_TRUE(first);
  key(Qt::Key_N);
  EXPECT_EQ(session.time(), *first);
  const auto second = window.review().nextEvent(*first);
  ASSERT_TRUE(second);
  key(Qt::Key_N);
  EXPECT_EQ(session.time(), *second);
  key(Qt::Key_N, Qt::ShiftModifier);
  EXPECT_EQ(session.time(), *first);
}

TEST_F(TimelineTest, EventRowGoesToMoment) {
  auto* dock = window.findChild<QDockWidget*>("events");
  ASSERT_TRUE(dock);
  dock->raise();
  EventPanel& events = *window.panels().events;
  ASSERT_TRUE(QTest::qWaitFor([&] { return events.isVisible(); }, kLimitMs));
  QTableView* table = events.table();
  ASSERT_EQ(table->model()->rowCount(), static_cast<int>(window.review().events().size()));
  const QModelIndex row = table->model()->index(2, EventTableModel::kPart);
  const RecordingEvent expected = window.review().events()[2];
  table->scrollTo(row);
  QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualRect(row).center());
  EXPECT_EQ(session.time(), expected.t_nearest);
  EXPECT_EQ(window.selection().pair(), window.review().pairOf(static_cast<std::size_t>(expected.part),
                                                              static_cast<std::size_t>(expected.link)));
  const int all = table->model()->rowCount();
  events.kindAction(EventKind::kNear)->setChecked(false);
  EXPECT_LT(table->model()->rowCount(), all);
  for (int r = 0; r < table->model()->rowCount(); ++r)
    EXPECT_NE(table->model()->index(r, EventTableModel::kKind).data().toString(), kindText(EventKind::kNear));
  EXPECT_FALSE(window.review().shownKinds()[static_cast<std::size_t>(EventKind::kNear)]);
}

TEST_F(TimelineTest, InAndOutSetRange) {
  window.playback().seek(3.0);
  key(Qt::Key_I);
  window.playback().seek(5.0);
  key(Qt::Key_O);
  EXPECT_EQ(window.timeAxis().range(), (TimeRange{3.0, 5.0}));
  key(Qt::Key_I, Qt::ShiftModifier);
  EXPECT_FALSE(window.timeAxis().range());
}

TEST_F(TimelineTest, GoesToTypedTime) {
  QLineEdit* field = window.panels().timeline->timeField();
  key(Qt::Key_G, Qt::ControlModifier);
  EXPECT_TRUE(field->hasFocus());
  QTest::keyClicks(field, "7.5");
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_EQ(session.time(), 7.5);
  EXPECT_TRUE(field->text().isEmpty());
  field->setFocus();
  QTest::keyClicks(field, "soon");
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_EQ(session.time(), 7.5);
  EXPECT_EQ(field->selectedText(), "soon");
}

TEST_F(TimelineTest, WheelZoomsLanesNotStrip) {
  const QPoint at(lanes().xOf(6.0), 5);
  QWheelEvent wheel(at, lanes().viewport()->mapToGlobal(at), {}, QPoint(0, 240), Qt::NoButton,
                    Qt::ControlModifier, Qt::NoScrollPhase, false);
  QApplication::sendEvent(lanes().viewport(), &wheel);
  EXPECT_TRUE(window.timeAxis().zoomed());
  EXPECT_NEAR(lanes().timeAt(at.x()), 6.0, 0.02);
  const TimeStrip* strip = window.panels().timeline->strip();
  EXPECT_NEAR(strip->timeAt(strip->xOf(11.9)), 11.9, 0.02) << "the strip shows all";
  // The moment that is gone to comes into view.
  window.playback().seek(6.0);
  window.playback().seek(0.0);
  EXPECT_EQ(window.timeAxis().view().from, 0.0);
  key(Qt::Key_Backspace, Qt::ControlModifier);
  EXPECT_FALSE(window.timeAxis().zoomed());
}

TEST_F(TimelineTest, MinimapShowsAndMovesWhatLanesShow) {
  TimeAxis& axis = window.timeAxis();
  TimeMinimap& map = *window.panels().timeline->minimap();
  EXPECT_FALSE(map.isVisible()) << "the lanes show everything";
  axis.setView({2.0, 5.0});
  ASSERT_TRUE(QTest::qWaitFor([&] { return map.isVisible() && map.width() > 200; }, kLimitMs));
  const double pixel = 12.0 / (map.width() - 2 * TimeMinimap::kSide - 1);
  EXPECT_NEAR(map.timeAt(map.xOf(3.3)), 3.3, pixel);
  const auto drag = [&](double from, double to) {
    const int y = map.height() / 2;
    QTest::mousePress(&map, Qt::LeftButton, {}, {map.xOf(from), y});
    // Mouse moves of QTest carry no buttons; the widget knows what it holds.
    QMouseEvent move(QEvent::MouseMove, QPointF(map.xOf(to), y), Qt::LeftButton, Qt::LeftButton, {});
    QApplication::sendEvent(&map, &move);
    QTest::mouseRelease(&map, Qt::LeftButton, {}, {map.xOf(to), y});
  };
  drag(3.0, 4.5);
  EXPECT_NEAR(axis.view().from, 3.5, 2 * pixel);
  EXPECT_NEAR(axis.view().length(), 3.0, 1e-9);
  drag(axis.view().to, 10.0);
  EXPECT_NEAR(axis.view().from, 3.5, 2 * pixel) << "the other end stays";
  EXPECT_NEAR(axis.view().to, 10.0, 2 * pixel);
  drag(axis.view().from, 8.0);
  EXPECT_NEAR(axis.view().from, 8.0, 2 * pixel);
  // A press beside the frame centres it there.
  drag(1.5, 1.5);
  EXPECT_NEAR(0.5 * (axis.view().from + axis.view().to), 1.5, 2 * pixel);
  drag(1.5, -3.0);
  EXPECT_EQ(axis.view().from, 0.0) << "not beyond the recording";
  EXPECT_EQ(session.time(), 0.0) << "the clock stays";
  key(Qt::Key_PageDown, Qt::AltModifier);
  EXPECT_NEAR(axis.view().from, 0.5 * axis.view().length(), 1e-9);
  key(Qt::Key_PageUp, Qt::AltModifier);
  EXPECT_EQ(axis.view().from, 0.0);
  axis.showAll();
  EXPECT_FALSE(map.isVisible());
}

TEST_F(TimelineTest, HoveringShowsNearestPair) {
  const auto hover = [](QWidget* over, const QPoint& at) {
    QMouseEvent move(QEvent::MouseMove, at, over->mapToGlobal(at), Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(over, &move);
  };
  TimeStrip* strip = window.panels().timeline->strip();
  hover(strip, {strip->xOf(1.5), strip->height() / 2});
  ASSERT_TRUE(QToolTip::isVisible()) << "at once";
  const double t = strip->timeAt(strip->xOf(1.5));
  const QString tip = QToolTip::text();
  EXPECT_EQ(tip, nearestMomentText(window.review(), t));
  EXPECT_TRUE(tip.contains(QStringLiteral("frame"))) << tip.toStdString();
  EXPECT_TRUE(tip.contains(QStringLiteral("±"))) << tip.toStdString();
  // Part 1 is nearest at 1.5 s; the moment decides, not the lane.
  EXPECT_TRUE(tip.contains(QStringLiteral("head – arm/link0"))) << tip.toStdString();
  hover(lanes().viewport(), {lanes().xOf(4.0), 6 * LaneView::kLaneHeight + 5});
  const QString hand = momentText(window.review(), 6, lanes().timeAt(lanes().xOf(4.0)));
  EXPECT_EQ(QToolTip::text(), hand);
}

TEST_F(TimelineTest, NoLanesWithoutAnalysis) {
  FakeSession plain;
  window.setSession(&plain);
  EXPECT_FALSE(lanes().isVisible());
  EXPECT_TRUE(window.panels().timeline->whatIf()->text().isEmpty());
  EXPECT_LE(window.panels().timeline->strip()->height(), 80);
  window.setSession(nullptr);
}

}  // namespace timeline_test
}  // namespace abstand::ui
