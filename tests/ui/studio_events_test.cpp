// Touches, margins and lost tracking in the window on a real session: a ball drives at a person.
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QDoubleSpinBox>
#include <QStatusBar>
#include <QTableView>
#include <QTest>
#include <set>

#include "core/base/output_file.hpp"
#include "core/base/text_file.hpp"
#include "humanmodel/human_model.hpp"
#include "tests/ui/slide_studio.hpp"
#include "tracking/table/skeleton_csv.hpp"
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

/// One of four hundred frames in which the person's right arm is not seen.
constexpr int kLostFrom = 250, kLostTo = 280;

/// Writes the person's recording without the right arm for a while.
void hideArm(const testing::ScratchFolder& folder) {
  tracking::Recording recording;
  const humanmodel::SkeletonFrame rest = humanmodel::makeHuman({}).rest;
  for (int i = 0; i <= 400; ++i) {
    humanmodel::SkeletonFrame frame = rest;
    frame.t = 0.01 * i;
    for (auto& p : frame.p) p.x() -= 0.3 * frame.t;
    using humanmodel::Joint;
    for (const Joint joint : {Joint::kElbowRight, Joint::kWristRight, Joint::kHandRight})
      if (i >= kLostFrom && i < kLostTo)
        frame.set(joint, Vector3d::Constant(kNaN), humanmodel::JointState::kMissing);
    recording.frames.push_back(frame);
  }
  tracking::writeSkeletonCsv(folder.path() / "person.csv", recording);
}

TEST_F(StudioEvents, KeysGoToEventsOfTheirKind) {
  hideArm(folder);
  open();
  // A margin that some part breaks, and another only comes near.
  const auto link = static_cast<int>(window.review().store()->layout().links.front().object);
  for (double metres = 0.05; metres < 0.6 && (of(EventKind::kNear).empty() || of(EventKind::kInside).empty());
       metres += 0.05) {
    window.panels().margins->row(link)->findChild<QDoubleSpinBox*>()->setValue(1e3 * metres);
    ASSERT_TRUE(QTest::qWaitFor([&] { return std::abs(window.review().objectMargin(link) - metres) < 1e-9; },
                                kLimitMs));
    QTest::qWait(50);
  }
  const struct {
    Qt::Key key;
    EventKind kind;
  } keys[] = {{Qt::Key_E, EventKind::kInside}, {Qt::Key_M, EventKind::kNear}, {Qt::Key_U, EventKind::kLost}};
  for (const auto& [k, kind] : keys) {
    SCOPED_TRACE(static_cast<char>(k));
    std::set<double> marks;
    for (const ui::RecordingEvent& event : of(kind))
      if (event.mark() > kFrame) marks.insert(event.mark());
    ASSERT_FALSE(marks.empty());
    window.playback().seek(0.0);
    ASSERT_TRUE(goesTo(0.0));
    double before = 0.0;
    for (const double mark : marks) {
      if (mark < before + 0.6 * kFrame) continue;  // in the same frame
      key(k);
      ASSERT_TRUE(goesTo(mark)) << mark;
      EXPECT_EQ(window.moment().playing, false);
      before = mark;
    }
    key(k);
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return window.statusBar()->currentMessage().startsWith("No later event known"); }, kLimitMs));
    EXPECT_TRUE(goesTo(before)) << "the clock stays";
    window.playback().seek(4.0);
    ASSERT_TRUE(goesTo(4.0));
    key(k, Qt::ShiftModifier);
    EXPECT_TRUE(goesTo(*marks.rbegin()) || goesTo(before));
  }
  const double lost = of(EventKind::kLost).front().t0;
  EXPECT_NEAR(lost, 0.01 * kLostFrom, 1.5 * kFrame);
}

/// The ball has a mass and stops before the person.
TEST_F(StudioEvents, KeyGoesToStopsThatWerePlayed) {
  folder.write("slide.mech",
               "units\nlength m\nangle degrees\nend_units\nmapping\ndof 0 1\nend_mapping\nchain\n"
               "frame 1 0 90 d 0\nend_chain\nlimits\nlimit 1 -5 5 10 500\nend_limits\n"
               "inertia\nbody 1 2 0 0 0 0.002 0.002 0.002 0 0 0\nend_inertia\n");
  std::string text = readFile(scene, 1 << 20, true);
  text.replace(text.find("    motion: go.csv\n"), 0, "    reaction: {stop: {distance: 0.4}}\n");
  writeFile(scene, text);
  SlideStudio::open();
  key(Qt::Key_S);
  EXPECT_TRUE(window.statusBar()->currentMessage().startsWith("No later event known"))
      << "nothing was played";
  key(Qt::Key_Space);
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return !of(EventKind::kStop).empty() && window.moment().t > 3.0; }, kLimitMs));
  key(Qt::Key_Space);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window.moment().playing; }, kLimitMs));
  const double stop = of(EventKind::kStop).front().t0;
  EXPECT_GT(stop, 0.5);
  key(Qt::Key_S, Qt::ShiftModifier);
  ASSERT_TRUE(goesTo(stop));
  key(Qt::Key_Home);
  ASSERT_TRUE(goesTo(0.0));
  QTest::qWait(200);
  ASSERT_EQ(of(EventKind::kStop).size(), 1u) << "what was played stays until it is played again";
  key(Qt::Key_S);
  EXPECT_TRUE(goesTo(stop));
}

}  // namespace studio_events_test
}  // namespace abstand::studio
