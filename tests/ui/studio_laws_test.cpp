// Laws are changed and links are poked in a real session.
#include <QAction>
#include <QLineEdit>
#include <QMouseEvent>
#include <QStatusBar>
#include <QUndoStack>
#include <algorithm>

#include "app/depth/open_session.hpp"
#include "tests/ui/studio_window.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/selection.hpp"
#include "ui/panel_set.hpp"
#include "ui/panels/law_row.hpp"
#include "ui/panels/reaction_panel.hpp"
#include "ui/style/actions.hpp"
#include "ui/viewport/opengl.hpp"
#include "ui/viewport/overlay.hpp"

namespace abstand::studio {
namespace studio_laws_test {

using ui::ActionId;

struct StudioLaws : StudioWindow {
  void SetUp() override {
    if (!ui::openGlInfo().available) GTEST_SKIP() << "no OpenGL 3.2 here";
    const std::string arm = testing::projectFile("data/robots/arm6/arm6.urdf").string();
    folder.write("arms.yaml",
                 "abstand: 1\ndefaults: {voxel: 0.05, point: 0.05, margin: 0.02}\n"
                 "mechanisms:\n"
                 "  - {name: arm, file: \"" +
                     arm +
                     "\", reaction: {torque: {gain: 2}}}\n"
                     "  - {name: still, file: \"" +
                     arm +
                     "\", base: {xyz: [0, 3, 0]}}\n"
                     "humans:\n  - {name: anna, recording: {file: walk.csv, place: {xyz: [4, 0, 0]}}}\n");
    outline =
        depth::openSession(scene_file::loadScene((folder.path() / "arms.yaml").string()), {})->outline();
    ASSERT_TRUE(opens([&] { window.openFile(in("arms.yaml")); })) << problem;
    for (QWidget* child : window.viewport().findChildren<QWidget*>())
      if (child->accessibleName() == QStringLiteral("3D view")) canvas = child;
    ASSERT_TRUE(canvas);
    look("arm/flange");
  }
  void look(const std::string& name) {
    window.selection().setObjects({indexOf(name)});
    window.viewport().fit();
    QTest::qWait(100);
    window.pull();
  }
  int indexOf(const std::string& name) const {
    for (std::size_t i = 0; i < outline.objects.size(); ++i)
      if (outline.objects[i].name == name) return static_cast<int>(i);
    ADD_FAILURE() << name;
    return 0;
  }
  const view::ObjectSnapshot& object(const std::string& name) const {
    return window.moment().objects[static_cast<std::size_t>(indexOf(name))];
  }
  void mouse(QEvent::Type type, const QPointF& at) {
    QMouseEvent event(type, at.toPoint(), type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
                      type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton,
                      Qt::ControlModifier | Qt::ShiftModifier);
    QApplication::sendEvent(canvas, &event);
  }
  QPointF pixelOf(const std::string& name) {
    return window.viewport().project(object(name).p_WCom).toPoint();
  }
  template <class Condition>
  bool shows(Condition condition) {
    return QTest::qWaitFor(
        [&] {
          window.pull();
          return condition(window.moment());
        },
        kLoadMs);
  }
  static double largestReaction(const view::SceneSnapshot& now) {
    double largest = 0.0;
    for (const view::TorqueParts& joint : now.joint_torques)
      largest = std::max(largest, std::abs(joint.reaction));
    return largest;
  }
  std::string status() const { return window.statusBar()->currentMessage().toStdString(); }

  view::SceneOutline outline;
  QWidget* canvas{nullptr};
};

TEST_F(StudioLaws, PokedArmYieldsAndFeelsNothingOnceReleased) {
  window.playback().setLoop(true);
  window.playback().setPlaying(true);
  const Vector3d before = object("arm/flange").p_WCom;
  const int steps = window.document().steps().index();
  const QPointF from = pixelOf("arm/flange");
  mouse(QEvent::MouseButtonPress, from);
  mouse(QEvent::MouseMove, from + QPointF(-60.0, 30.0));
  ASSERT_TRUE(shows([&](const view::SceneSnapshot& now) {
    return now.movers.poke.object == indexOf("arm/flange") && largestReaction(now) > 1.0;
  })) << status();
  // Longer than a poke lasts that nobody renews.
  QTest::qWait(600);
  ASSERT_TRUE(shows([&](const view::SceneSnapshot& now) { return now.movers.poke.object >= 0; }));
  const auto& labels = window.viewport().overlay().content().labels;
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const ui::OverlayLabel& label) {
    return label.text.startsWith("Poke: ") && label.text.endsWith(" N");
  }));
  EXPECT_GT((object("arm/flange").p_WCom - before).norm(), 1e-3) << "it yields";
  mouse(QEvent::MouseButtonRelease, from);
  ASSERT_TRUE(shows([&](const view::SceneSnapshot& now) {
    return now.movers.poke.object < 0 && largestReaction(now) == 0.0;
  }));
  EXPECT_EQ(window.document().steps().index(), steps) << "a poke is no edit";
}

TEST_F(StudioLaws, SaysWhyARobotDoesNotYield) {
  const auto poke = [&](const std::string& name) {
    look(name);
    window.actions()[ActionId::kPoke]->trigger();
    return status();
  };
  EXPECT_EQ(poke("still/flange"), "still cannot react to a poke: the scene file gives it no reaction");
  EXPECT_EQ(poke("anna/head"), "Only links of robots can be poked");
  EXPECT_EQ(poke("arm/base"), "No joint moves this link");
  EXPECT_EQ(poke("arm/flange"), "Poke: press Play to see the robot yield");
  window.document().edit("off", [](ui::Work& w) { w.reactions["arm"].laws["torque"] = false; });
  EXPECT_EQ(poke("arm/flange"), "arm does not yield to a poke: its law Torque is off (panel Laws)");
  window.document().steps().undo();
  window.actions()[ActionId::kReact]->setChecked(false);
  ASSERT_TRUE(shows([](const view::SceneSnapshot& now) { return now.robots.empty(); }));
  EXPECT_EQ(poke("arm/flange"), "arm does not react to a poke: React is off");
  window.selection().clear();
  window.actions()[ActionId::kPoke]->trigger();
  EXPECT_EQ(status(), "Select one link of a robot first");
}

TEST_F(StudioLaws, KeyPushesForAWhile) {
  window.playback().setLoop(true);
  window.playback().setPlaying(true);
  window.actions()[ActionId::kPoke]->trigger();
  ASSERT_TRUE(shows([&](const view::SceneSnapshot& now) { return largestReaction(now) > 1.0; })) << status();
  ASSERT_TRUE(shows([&](const view::SceneSnapshot& now) {
    return now.movers.poke.object < 0 && largestReaction(now) == 0.0;
  })) << "it ends by itself";
}

TEST_F(StudioLaws, ChangedGainIsHeardWhilePlaying) {
  window.playback().setLoop(true);
  window.playback().setPlaying(true);
  const auto& rows = window.panels().reactions->rows();
  const auto gain = std::find_if(rows.begin(), rows.end(),
                                 [](const ui::LawRow* row) { return row->key() == "torque.gain"; });
  ASSERT_NE(gain, rows.end());
  EXPECT_EQ((*gain)->field()->text(), "2") << "as the scene file says";
  QTest::keyClick((*gain)->field(), Qt::Key_A, Qt::ControlModifier);
  QTest::keyClicks((*gain)->field(), "0");
  QTest::keyClick((*gain)->field(), Qt::Key_Return);
  mouse(QEvent::MouseButtonPress, pixelOf("arm/flange"));
  mouse(QEvent::MouseMove, pixelOf("arm/flange") + QPointF(-60.0, 30.0));
  ASSERT_TRUE(shows([&](const view::SceneSnapshot& now) { return now.movers.poke.object >= 0; })) << status();
  QTest::qWait(100);
  window.pull();
  EXPECT_EQ(largestReaction(window.moment()), 0.0);
  window.document().steps().undo();
  ASSERT_TRUE(shows([&](const view::SceneSnapshot& now) { return largestReaction(now) > 1.0; }));
  mouse(QEvent::MouseButtonRelease, pixelOf("arm/flange"));
}

}  // namespace studio_laws_test
}  // namespace abstand::studio
