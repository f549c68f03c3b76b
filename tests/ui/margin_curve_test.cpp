// The curve of a margin with its handle, and two sets of margins beside each other.
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QMouseEvent>
#include <QTest>
#include <QToolButton>

#include "tests/support/paths.hpp"
#include "tests/ui/fake_analysis.hpp"
#include "tests/ui/shown_window.hpp"
#include "ui/document/document.hpp"
#include "ui/document/project_file.hpp"
#include "ui/model/event_text.hpp"
#include "ui/model/recording_review.hpp"
#include "ui/model/selection.hpp"
#include "ui/panels/compare_lanes.hpp"
#include "ui/panels/margin_curve.hpp"
#include "ui/panels/margin_panel.hpp"
#include "ui/panels/margin_row.hpp"
#include "ui/panels/timeline_panel.hpp"
#include "ui/style/actions.hpp"

namespace abstand::ui {
namespace margin_curve_test {

struct MarginCurveTest : ShownWindow {
  void SetUp() override {
    ShownWindow::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    torso = session.indexOf("operator/torso");
    session.recording = &analysis;
    session.setMargin(torso, 0.04);  // so that there is a snapshot again
    window.setSession(&session);
    dock = window.findChild<QDockWidget*>("curve");
    dock->raise();
  }
  void TearDown() override { window.setSession(nullptr); }
  QAction* action(ActionId id) { return window.actions()[id]; }
  MarginCurve& curve() { return *window.panels().curve; }
  CompareLanes& lanes() { return *window.panels().timeline->compareLanes(); }
  int steps() { return window.document().steps().count(); }
  double margin() { return window.panels().margins->row(torso)->metres(); }
  void analyse() {
    analysis.runAll();
    window.review().pull();
    ASSERT_TRUE(QTest::qWaitFor([&] { return curve().isVisible() && curve().complete(); }, kWaitMs));
  }
  void judged() { QCoreApplication::processEvents(); }

  FakeAnalysis analysis{session.outline(), [](std::size_t part, std::size_t frame) {
                          return valley(part, 0.02 * static_cast<double>(frame)) - 0.1;
                        }};
  int torso{0};
  QDockWidget* dock{nullptr};
};

TEST_F(MarginCurveTest, ShowsCostOfEachMargin) {
  EXPECT_TRUE(curve().points().empty());
  EXPECT_TRUE(curve().sentence()->text().contains("After the analysis"));
  analyse();
  EXPECT_EQ(curve().parts()->currentText(), "torso");
  double share = 0.0;
  for (const MarginCurve::Point& point : curve().points()) {
    EXPECT_EQ(point.outcome.stops, window.review().outcomeOf(0, point.margin).stops);
    EXPECT_GE(point.outcome.stoppedShare(), share) << "grows with the margin";
    share = point.outcome.stoppedShare();
  }
  EXPECT_GT(share, 0.0);
  EXPECT_GT(curve().points().front().outcome.missed_stops, 0);
  EXPECT_EQ(curve().points().back().outcome.missed_stops, 0);
  EXPECT_TRUE(curve().sentence()->text().startsWith("40 mm: ")) << curve().sentence()->text().toStdString();
  window.selection().setObjects({session.indexOf("operator/hand_left")});
  EXPECT_EQ(curve().parts()->currentText(), "hand_left");
}

TEST_F(MarginCurveTest, HandleMovesMarginInOneStep) {
  analyse();
  QWidget* area = curve().area();
  const int before = steps();
  QTest::mousePress(area, Qt::LeftButton, {}, curve().handle());
  for (const double metres : {0.08, 0.12, 0.2}) {
    QMouseEvent move(QEvent::MouseMove, QPoint(curve().xOf(metres), area->height() / 2), Qt::NoButton,
                     Qt::LeftButton, {});
    QApplication::sendEvent(area, &move);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
          return std::abs(window.document().work().margins.value("operator/torso", -1.0) - metres) < 2e-3;
        },
        kWaitMs));
  }
  QTest::mouseRelease(area, Qt::LeftButton, {}, QPoint(curve().xOf(0.2), 20));
  EXPECT_EQ(steps(), before + 1);
  EXPECT_NEAR(margin(), 0.2, 2e-3);
  EXPECT_NEAR(curve().handle().x(), curve().xOf(margin()), 1);
  action(ActionId::kUndo)->trigger();
  EXPECT_NEAR(margin(), 0.04, 1e-12);
  // A locked one stays.
  window.panels().margins->row(torso)->findChild<QToolButton*>("lock")->click();
  QTest::mouseClick(area, Qt::LeftButton, {}, QPoint(curve().xOf(0.15), 20));
  EXPECT_NEAR(margin(), 0.04, 1e-12);
}

TEST_F(MarginCurveTest, LinkMarginsChangeCurve) {
  analyse();
  const double before = curve().points().front().outcome.stoppedShare();
  action(ActionId::kMargins100)->trigger();
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return curve().complete() && curve().points().front().outcome.stoppedShare() > before; },
      kWaitMs));
}

TEST_F(MarginCurveTest, ComparesTwoSetsUntilClosed) {
  analyse();
  EXPECT_FALSE(lanes().isVisible());
  action(ActionId::kCompareMargins)->trigger();
  EXPECT_EQ(steps(), 1);
  ASSERT_TRUE(lanes().isVisible());
  const auto kept = window.review().review().outcome;
  EXPECT_EQ(lanes().compared().stops, kept.stops);
  EXPECT_TRUE(lanes().text().contains("as many stops")) << lanes().text().toStdString();
  action(ActionId::kNoMargins)->trigger();
  judged();
  const auto now = window.review().review().outcome;
  ASSERT_LT(now.stoppedShare(), kept.stoppedShare());
  EXPECT_EQ(lanes().compared().stops, kept.stops) << "set B stays";
  EXPECT_TRUE(lanes().text().contains("% of the time less")) << lanes().text().toStdString();
  EXPECT_TRUE(lanes().text().contains("A: " + outcomeText(now)));
  EXPECT_TRUE(lanes().text().contains("B: " + outcomeText(kept)));
  ASSERT_FALSE(lanes().stops(1).empty());
  double stands[2] = {0.0, 0.0};
  for (const int set : {0, 1})
    for (const TimeRange& stop : lanes().stops(set)) stands[set] += stop.length();
  EXPECT_NEAR(stands[0], now.stopped_time, 1e-9);
  EXPECT_NEAR(stands[1], kept.stopped_time, 1e-9);
  // It is saved.
  testing::ScratchFolder folder;
  const QString file = QString::fromStdString((folder.path() / "p.abstand").string());
  writeProject(window.document().project(), file);
  window.document().open(readProject(file), file, false);
  window.setSession(&session);
  EXPECT_TRUE(action(ActionId::kCompareMargins)->isChecked());
  EXPECT_EQ(window.document().work().compared->value("operator/torso"), 0.04);
  action(ActionId::kCompareMargins)->trigger();
  EXPECT_FALSE(window.document().work().compared);
  action(ActionId::kUndo)->trigger();
  EXPECT_TRUE(window.document().work().compared);
  lanes().findChild<QToolButton*>("close_compare")->click();
  EXPECT_FALSE(lanes().isVisible());
  EXPECT_FALSE(action(ActionId::kCompareMargins)->isChecked());
}

}  // namespace margin_curve_test
}  // namespace abstand::ui
