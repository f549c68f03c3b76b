// A robot that is stopped, slowed down or posed by hand is seen in the 3D view, with the reason.
#include <gtest/gtest.h>

#include <QDockWidget>
#include <QLabel>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "tests/ui/shown_window.hpp"
#include "ui/model/selection.hpp"
#include "ui/model/stop_text.hpp"
#include "ui/panels/robot_panel.hpp"
#include "ui/style/theme.hpp"
#include "ui/viewport/overlay.hpp"

namespace abstand::ui {
namespace stop_picture_test {

using safety::StopState;

struct StopDisplay : ShownWindow {
  void SetUp() override {
    ShownWindow::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    session.seek(0.0);
    window.pull();
    // The pair of the arm that is farthest away: no line would show it by its distance.
    double farthest = -kInfinity;
    for (std::size_t p = 0; p < session.outline().pairs.size(); ++p) {
      const auto [a, b] = session.outline().pairs[p];
      const double d = window.moment().pairs[p].result.distance;
      if (session.outline().objects[static_cast<std::size_t>(a)].group != "arm" || d <= farthest) continue;
      farthest = d;
      cause = static_cast<int>(p);
    }
  }
  void stop(StopState state) {
    session.setRobot([&](view::SceneSnapshot&, view::RobotSnapshot& robot) {
      robot.state = state;
      robot.cause = {safety::StopReason::kDistance, 0.0398, 0.04, cause, -1};
    });
    window.pull();
  }
  const OverlayContent& content() const { return window.viewport().overlay().content(); }
  const OverlayLabel* label(const QString& begins) const {
    const auto at = std::find_if(content().labels.begin(), content().labels.end(),
                                 [&](const OverlayLabel& label) { return label.text.startsWith(begins); });
    return at == content().labels.end() ? nullptr : &*at;
  }
  /// A line between the bodies of `cause`.
  bool showsCause() const {
    const query::PairResult& result = window.moment().pairs[static_cast<std::size_t>(cause)].result;
    const QPointF a = window.viewport().project(result.witness_a);
    const QPointF b = window.viewport().project(result.witness_b);
    return std::any_of(content().segments.begin(), content().segments.end(), [&](const OverlaySegment& s) {
      return (s.a - a).manhattanLength() < 0.5 && (s.b - b).manhattanLength() < 0.5;
    });
  }
  /// The bodies, without what is written over them.
  QImage bodies() {
    const ViewOptions options = window.viewport().options();
    ViewOptions bare = options;
    bare.labels = bare.closest = bare.forces = bare.torques = false;
    window.viewport().setOptions(bare);
    const QImage image = window.viewport().picture();
    window.viewport().setOptions(options);
    window.viewport().picture();
    return image;
  }
  struct Change {
    int pixels{0};
    double towards_amber{0.0};  ///< sum of how much nearer they came to it in the colour cube
  };
  static Change changeOf(const QImage& before, const QImage& after) {
    constexpr double kSeen = 0.1;
    const QColor amber(kAmber);
    Change change;
    EXPECT_EQ(before.size(), after.size()) << "a stop does not change the layout";
    if (before.size() != after.size()) return change;
    for (int y = 0; y < before.height(); ++y)
      for (int x = 0; x < before.width(); ++x) {
        const QColor a(before.pixel(x, y)), b(after.pixel(x, y));
        if (distance(a, b) < kSeen) continue;
        ++change.pixels;
        change.towards_amber += distance(a, amber) - distance(b, amber);
      }
    return change;
  }
  static double distance(const QColor& a, const QColor& b) {
    return std::hypot(a.redF() - b.redF(), a.greenF() - b.greenF(), a.blueF() - b.blueF());
  }

  int cause{-1};
};

TEST_F(StopDisplay, StopIsDrawnWithPairAndDistance) {
  EXPECT_FALSE(label("⚠ arm, "));
  EXPECT_FALSE(showsCause());
  const QImage before = bodies();
  stop(StopState::kProtectiveStop);
  const OverlayLabel* stopped = label("⚠ arm, protective stop: ");
  ASSERT_TRUE(stopped);
  EXPECT_EQ(stopped->text, QStringLiteral("⚠ arm, %1").arg(stopText(session.outline(), window.moment(), 0)));
  EXPECT_TRUE(stopped->text.endsWith(" at 39.8 mm"));
  EXPECT_EQ(stopped->style, OverlayLabel::Style::kContact);
  EXPECT_TRUE(showsCause());
  const QImage stopped_picture = bodies();
  const Change change = changeOf(before, stopped_picture);
  EXPECT_GT(change.pixels, 300) << "of the links that are not in contact";
  EXPECT_GT(change.towards_amber, 0.0);
  stop(StopState::kRunning);
  EXPECT_FALSE(label("⚠ arm, "));
  EXPECT_EQ(changeOf(before, bodies()).pixels, 0);
}

TEST_F(StopDisplay, SlowedRobotDiffersFromStoppedRobot) {
  stop(StopState::kSlowing);
  const OverlayLabel* slowed = label("▲ arm, slowed down: ");
  ASSERT_TRUE(slowed);
  EXPECT_EQ(slowed->style, OverlayLabel::Style::kNear);
  EXPECT_TRUE(showsCause());
  const QImage picture = window.viewport().picture();
  stop(StopState::kWaitingForReset);
  const OverlayLabel* waiting = label("⚠ arm, waiting for reset: ");
  ASSERT_TRUE(waiting);
  EXPECT_TRUE(waiting->text.endsWith(" (reset: Shift+R)")) << waiting->text.toStdString();
  EXPECT_NE(window.viewport().picture(), picture);
}

TEST_F(StopDisplay, RobotPanelSelectsPair) {
  window.findChild<QDockWidget*>(QStringLiteral("robots"))->raise();
  auto* select = window.panels().robots->findChild<QToolButton*>(QStringLiteral("select arm"));
  ASSERT_TRUE(select);
  EXPECT_TRUE(select->isHidden());
  stop(StopState::kProtectiveStop);
  ASSERT_FALSE(select->isHidden());
  select->click();
  EXPECT_EQ(window.selection().pair(), cause);
  session.poseJoint(0, 0.1);
  window.pull();
  EXPECT_TRUE(select->isHidden()) << "its reaction rests";
  EXPECT_EQ(window.panels().robots->findChild<QLabel*>(QStringLiteral("state arm"))->text(),
            "arm: posed by hand");
}

TEST_F(StopDisplay, PosedRobotIsLabelled) {
  session.poseJoint(2, 0.7);
  window.pull();
  EXPECT_TRUE(label("arm is posed by hand"));
  session.followMotion(0);
  window.pull();
  EXPECT_FALSE(label("arm is posed by hand"));
}

}  // namespace stop_picture_test
}  // namespace abstand::ui
