// Touches, margins and lost tracking in the window on a real session: a ball drives at a person.
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QDoubleSpinBox>
#include <QTableView>
#include <QTest>

#include "tests/ui/slide_studio.hpp"
#include "ui/model/event_table_model.hpp"
#include "ui/model/pair_table_model.hpp"
#include "ui/model/playback.hpp"
#include "ui/panels/event_panel.hpp"
#include "ui/panels/margin_panel.hpp"
#include "ui/panels/margin_row.hpp"
#include "ui/panels/pair_panel.hpp"
#include "ui/plots/plot_panel.hpp"
#include "ui/plots/strip_chart.hpp"

namespace abstand::studio {
namespace studio_events_test {

constexpr double kFrame = 0.01;  // s
using ui::EventKind;

struct StudioEvents : SlideStudio {
  StudioEvents() : SlideStudio({.robot = 0.8, .person = 0.3, .seconds = 4.0}) {}
  void open() {
    SlideStudio::open();
    ASSERT_TRUE(analysed()) << window.review().problem().toStdString();
  }
  std::vector<ui::RecordingEvent> of(EventKind kind) const {
    std::vector<ui::RecordingEvent> found;
    for (const ui::RecordingEvent& event : window.review().events())
      if (event.kind == kind) found.push_back(event);
    return found;
  }
  bool goesTo(double t) {
    return QTest::qWaitFor([&] { return std::abs(window.moment().t - t) < 0.5 * kFrame; }, kLimitMs);
  }
  void key(Qt::Key k, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QApplication::setActiveWindow(&window);
    QTest::keyClick(&window, k, modifiers);
  }
  /// The person's nearest pair at this moment.
  const view::PairSnapshot& nearest() const {
    return window.moment().pairs[static_cast<std::size_t>(window.moment().nearest_pair)];
  }
};

TEST_F(StudioEvents, TouchBeginsWhereDistanceIsWithinItsBound) {
  open();
  const auto touches = of(EventKind::kContact);
  ASSERT_FALSE(touches.empty()) << "the ball drives into the person";
  const double first = touches.front().t0;
  window.playback().seek(0.0);
  ASSERT_TRUE(goesTo(0.0));
  key(Qt::Key_X);
  ASSERT_TRUE(goesTo(first)) << "key of touches";
  EXPECT_LE(nearest().result.distance, nearest().result.bound + 1e-3);
  window.playback().seek(first - 2.0 * kFrame);
  ASSERT_TRUE(goesTo(first - 2.0 * kFrame));
  EXPECT_GT(nearest().result.distance, nearest().result.bound - 1e-3);
  EXPECT_GE(first, 0.5);
  // In the table, the words of the pair table.
  ui::EventPanel& panel = *window.panels().events;
  for (const EventKind kind :
       {EventKind::kBetweenFrames, EventKind::kInside, EventKind::kNear, EventKind::kStop, EventKind::kLost})
    panel.kindAction(kind)->setChecked(false);
  panel.parentWidget()->show();
  panel.parentWidget()->raise();
  ASSERT_TRUE(QTest::qWaitFor([&] { return panel.isVisible(); }, kLimitMs));
  ASSERT_EQ(panel.table()->model()->rowCount(), static_cast<int>(touches.size()));
  EXPECT_EQ(panel.table()->model()->index(0, ui::EventTableModel::kKind).data().toString(), "touching");
  // N goes to the kinds that are shown.
  window.playback().seek(0.0);
  ASSERT_TRUE(goesTo(0.0));
  key(Qt::Key_N);
  EXPECT_TRUE(goesTo(first));
}

TEST_F(StudioEvents, MarginEditChangesIntrusionsAndMarksForces) {
  open();
  const auto touches = of(EventKind::kContact);
  ASSERT_FALSE(touches.empty());
  // A tenth of a second before the touch nothing touches; with a wide margin it is inside.
  const double t = touches.front().t0 - 0.1;
  const auto& layout = window.review().store()->layout();
  const std::size_t link = layout.links.front().object;
  const auto setMargin = [&](double metres) {
    ui::MarginRow* row = window.panels().margins->row(static_cast<int>(link));
    ASSERT_TRUE(row);
    row->findChild<QDoubleSpinBox*>()->setValue(1e3 * metres);
  };
  setMargin(0.3);
  window.playback().seek(t);
  ASSERT_TRUE(goesTo(t));
  ASSERT_TRUE(QTest::qWaitFor([&] { return nearest().result.contacts > 0; }, kLimitMs));
  const auto charts = window.panels().plots->charts();
  ASSERT_TRUE(QTest::qWaitFor([&] { return charts[1]->series(1)->at(t) > 0.0; }, kLimitMs));
  EXPECT_EQ(charts[1]->shownNow(0), 0.0) << "nothing touches";
  EXPECT_GT(charts[1]->shownNow(1), 0.0);
  const int pair = window.moment().nearest_pair;
  const auto* pairs = window.panels().pairs->model();
  EXPECT_EQ(pairs->index(pair, ui::PairTableModel::kState).data().toString(), "⚠ inside margin");
  EXPECT_TRUE(pairs->index(pair, 0).data(Qt::ToolTipRole).toString().contains("virtual (margin) force"));
  EXPECT_TRUE(pairs->index(pair, 0).data(Qt::ToolTipRole).toString().contains("closing at 1.10 m/s"))
      << pairs->index(pair, 0).data(Qt::ToolTipRole).toString().toStdString();
  // Away from there, the margin goes; what was played is of an earlier one.
  window.playback().seek(0.2);
  ASSERT_TRUE(goesTo(0.2));
  setMargin(0.0);
  EXPECT_TRUE(QTest::qWaitFor([&] { return std::isnan(charts[1]->series(1)->at(t)); }, kLimitMs));
  ASSERT_EQ(charts[1]->lines(), 3u);
  EXPECT_GT(charts[1]->series(2)->at(t), 0.0);
  EXPECT_EQ(of(EventKind::kContact).size(), touches.size()) << "margins do not change touches";
}

}  // namespace studio_events_test
}  // namespace abstand::studio
