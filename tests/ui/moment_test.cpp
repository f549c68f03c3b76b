// All parts of the window show the same moment, where it is.
#include <gtest/gtest.h>

#include <QAction>
#include <QLabel>
#include <QTableView>
#include <algorithm>

#include "tests/ui/shown_window.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/selection.hpp"
#include "ui/panels/pair_panel.hpp"
#include "ui/style/actions.hpp"
#include "ui/style/format.hpp"
#include "ui/viewport/overlay.hpp"

namespace abstand::ui {
namespace {

constexpr double kPixel = 0.5;

struct MomentTest : ShownWindow {
  void expectOneMoment() {
    for (const auto& [part, step] : window.shownSteps()) EXPECT_EQ(step, window.moment().step) << part;
    EXPECT_NEAR(window.playback().time(), window.moment().t, 1e-9);
  }
  /// The picture stands still.
  bool rests() {
    return QTest::qWaitFor(
        [&, last = -1L]() mutable {
          QTest::qWait(150);
          return std::exchange(last, window.viewport().framesDrawn()) == window.viewport().framesDrawn();
        },
        kWaitMs);
  }
};

TEST_F(MomentTest, AllPanelsShowDrawnMoment) {
  int seen = 0;
  QObject::connect(&window, &MainWindow::momentShown, &window, [&] {
    expectOneMoment();
    ++seen;
  });
  window.playback().setPlaying(true);
  long last = -1;
  for (int i = 0; i < 40; ++i) {
    session.advance(0.02);
    QTest::qWait(7);
    expectOneMoment();
    if (window.moment().step != last) last = window.moment().step;
  }
  EXPECT_GT(seen, 1);
  EXPECT_GT(last, 0);
  window.playback().setPlaying(false);
}

TEST_F(MomentTest, ReshownPanelShowsCurrentMoment) {
  QWidget* dock = window.panels().pairs->parentWidget();
  dock->hide();
  session.seek(0.4);
  window.pull();
  dock->show();
  QTest::qWait(20);
  expectOneMoment();
  const auto* model = window.panels().pairs->table()->model();
  const int pair = window.moment().nearest_pair;
  ASSERT_GE(pair, 0);
  window.panels().pairs->sortAgain();
  EXPECT_EQ(model->index(0, PairTableModel::kDistance).data().toString(),
            lengthNumber(window.moment().pairs[static_cast<std::size_t>(pair)].result.distance));
}

TEST_F(MomentTest, SignalsVisibleRowsOnly) {
  int announced = 0;
  QObject::connect(
      window.panels().pairs->table()->model(), &QAbstractItemModel::dataChanged, &window,
      [&](const QModelIndex& from, const QModelIndex& to) { announced += to.row() - from.row() + 1; });
  session.seek(1.0);
  window.pull();
  const QTableView* table = window.panels().pairs->table();
  EXPECT_GT(announced, 0);
  EXPECT_LE(announced, table->viewport()->height() / table->rowHeight(0) + 2);
}

TEST_F(MomentTest, OverlayFollowsWindowSize) {
  session.seek(0.4);
  window.pull();
  const int hand = session.indexOf("operator/hand_left");
  window.selection().setObjects({hand});
  for (const QSize size : {QSize(1300, 900), QSize(1150, 760), QSize(1400, 820)}) {
    window.resize(size);
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.size() == size; }, kWaitMs));
    QCoreApplication::sendPostedEvents();
    const Vector3d& p = window.moment().objects[static_cast<std::size_t>(hand)].p_WCom;
    const QPointF anchor = window.viewport().project(p);
    const auto& labels = window.viewport().overlay().content().labels;
    EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [&](const OverlayLabel& label) {
      return (label.at - anchor).manhattanLength() < kPixel;
    })) << size.width();
    EXPECT_EQ(window.viewport().overlay().size(), window.viewport().size());
  }
}

TEST_F(MomentTest, LabelsDoNotCoverTheirPoints) {
  for (const double t : {0.2, 0.4, 0.6, 5.5}) {
    session.seek(t);
    window.pull();
    const Overlay& overlay = window.viewport().overlay();
    for (const PlacedLabel& placed : overlay.placeLabels())
      for (const OverlaySegment& segment : overlay.content().segments) {
        EXPECT_FALSE(placed.box.contains(segment.a)) << placed.label.text.toStdString() << " at " << t;
        EXPECT_FALSE(placed.box.contains(segment.b)) << placed.label.text.toStdString() << " at " << t;
      }
  }
}

TEST_F(MomentTest, RestingPictureHasFullQuality) {
  session.seek(0.4);
  window.pull();
  ASSERT_TRUE(rests());
  const QImage alone = window.viewport().picture();
  // Many changes in a row, which are drawn cheaply, back to the same moment.
  for (const double t : {0.5, 0.6, 0.7, 0.8, 0.4}) {
    session.seek(t);
    window.pull();
  }
  ASSERT_TRUE(rests());
  const long frames = window.viewport().framesDrawn();
  EXPECT_EQ(window.viewport().grab().toImage().convertToFormat(QImage::Format_RGB32),
            window.viewport().picture());
  EXPECT_EQ(window.viewport().picture(), alone);
  EXPECT_EQ(window.viewport().framesDrawn(), frames + 2) << "only the pictures that were asked for";
}

/// Share of the pixels that differ much in any colour.
double differing(const QImage& a, const QImage& b) {
  long n = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const QColor p(a.pixel(x, y)), q(b.pixel(x, y));
      n += std::max({std::abs(p.red() - q.red()), std::abs(p.green() - q.green()),
                     std::abs(p.blue() - q.blue())}) > 40;
    }
  return static_cast<double>(n) / (static_cast<double>(a.width()) * a.height());
}

TEST_F(MomentTest, DraftQualityDiffersAtEdgesOnly) {
  constexpr double kEdges = 0.02;
  for (const bool camera : {false, true}) {
    for (const double t : {0.1, 0.2, 0.3, 0.4}) {
      session.seek(t);
      if (camera) window.viewport().orbit(3.0, 0.0);
      window.pull();
    }
    const QImage cheap = window.viewport().grab().toImage();
    const QImage full = window.viewport().picture();
    ASSERT_EQ(cheap.size(), full.size());
    EXPECT_LT(differing(cheap, full), kEdges) << "the camera moves: " << camera;
  }
}

}  // namespace
}  // namespace abstand::ui
