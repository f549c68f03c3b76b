// Links of a robot are pulled with the mouse and moved by keys, in a real session.
#include <QAction>
#include <QMouseEvent>
#include <QStatusBar>
#include <QUndoStack>
#include <QWidget>
#include <cmath>

#include "app/depth/open_session.hpp"
#include "tests/ui/studio_window.hpp"
#include "ui/model/selection.hpp"
#include "ui/style/actions.hpp"
#include "ui/viewport/opengl.hpp"

namespace abstand::studio {
namespace studio_drag_test {

using ui::ActionId;

struct StudioDrag : StudioWindow {
  static constexpr double kReached = 2e-6;  // m: twice the tolerance of PointReach

  void SetUp() override {
    if (!ui::openGlInfo().available) GTEST_SKIP() << "no OpenGL 3.2 here";
    folder.write("arm.yaml",
                 "abstand: 1\ndefaults: {voxel: 0.05, point: 0.05, margin: 0.02}\n"
                 "mechanisms:\n  - {name: arm, file: \"" +
                     testing::projectFile("data/robots/arm6/arm6.urdf").string() +
                     "\"}\nhumans:\n  - {name: anna, recording: {file: walk.csv}}\n");
    outline = depth::openSession(scene_file::loadScene((folder.path() / "arm.yaml").string()), {})->outline();
    ASSERT_TRUE(opens([&] { window.openFile(in("arm.yaml")); })) << problem;
    for (QWidget* child : window.viewport().findChildren<QWidget*>())
      if (child->accessibleName() == QStringLiteral("3D view")) canvas = child;
    ASSERT_TRUE(canvas);
    ASSERT_TRUE(indexOf("arm/flange") >= 0);
    window.selection().setObjects({indexOf("arm/flange")});
    window.viewport().fit();
    QTest::qWait(100);
    window.pull();
  }
  int indexOf(const std::string& name) const {
    for (std::size_t i = 0; i < outline.objects.size(); ++i)
      if (outline.objects[i].name == name) return static_cast<int>(i);
    return -1;
  }
  const view::ObjectSnapshot& object(const std::string& name) const {
    return window.moment().objects[static_cast<std::size_t>(indexOf(name))];
  }
  void mouse(QEvent::Type type, const QPointF& at) {
    QMouseEvent event(type, at.toPoint(), type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
                      type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton,
                      Qt::ControlModifier);
    QApplication::sendEvent(canvas, &event);
  }
  QPointF pixelOf(const std::string& name) {
    return window.viewport().project(object(name).p_WCom).toPoint();
  }
  /// What the document says is what is drawn.
  bool shows() {
    const QVector<double> posed = work().posed["arm"];
    return QTest::qWaitFor(
        [&] {
          window.pull();
          for (int k = 0; k < posed.size(); ++k)
            if (std::abs(window.moment().joint_positions[static_cast<std::size_t>(k)] - posed[k]) > 1e-12)
              return false;
          return !posed.isEmpty();
        },
        kLoadMs);
  }
  void expectWithinLimits() {
    const QVector<double> posed = work().posed["arm"];
    ASSERT_EQ(posed.size(), static_cast<int>(outline.joints.size()));
    for (int k = 0; k < posed.size(); ++k) {
      EXPECT_GE(posed[k], outline.joints[static_cast<std::size_t>(k)].lower) << k;
      EXPECT_LE(posed[k], outline.joints[static_cast<std::size_t>(k)].upper) << k;
    }
  }
  double nearest() {
    return window.moment().pairs[static_cast<std::size_t>(window.moment().nearest_pair)].result.distance;
  }
  view::SceneOutline outline;
  QWidget* canvas{nullptr};
};

TEST_F(StudioDrag, LinkFollowsPointerInOneUndoStep) {
  const QPointF from = pixelOf("arm/flange");
  const int steps = window.document().steps().index();
  const Transform before = object("arm/flange").X_WB;
  std::vector<double> distances;
  for (const view::PairSnapshot& pair : window.moment().pairs) distances.push_back(pair.result.distance);
  mouse(QEvent::MouseButtonPress, from);
  EXPECT_TRUE(work().posed.isEmpty()) << "held, and not moved";
  const QPointF to = from + QPointF(-30.0, 20.0);
  for (int k = 1; k <= 10; ++k) mouse(QEvent::MouseMove, from + 0.1 * k * (to - from));
  ASSERT_TRUE(shows());
  expectWithinLimits();
  long changed = 0;
  for (std::size_t i = 0; i < distances.size(); ++i)
    changed += window.moment().pairs[i].result.distance != distances[i];
  EXPECT_GT(changed, 0) << "distances follow";
  mouse(QEvent::MouseButtonRelease, to);
  EXPECT_EQ(window.document().steps().index(), steps + 1);
  // The grabbed point of the surface is under the pointer: its way in the picture is that of the pointer.
  EXPECT_GT((object("arm/flange").X_WB.translation() - before.translation()).norm(), 0.005);
  mouse(QEvent::MouseMove, to + QPointF(50.0, 50.0));
  EXPECT_EQ(window.document().steps().index(), steps + 1) << "let go";
  window.actions()[ActionId::kUndo]->trigger();
  EXPECT_TRUE(work().posed.isEmpty());
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        window.pull();
        return object("arm/flange").X_WB.isApprox(before, 1e-9);
      },
      kLoadMs));
}

TEST_F(StudioDrag, GrabbedPointStaysUnderPointer) {
  // Signals of the view tell the point of the surface.
  Vector3d p_B = Vector3d::Constant(kNaN);
  QObject::connect(&window.viewport(), &ui::Viewport::bodyGrabbed, &window, [&](int i, const Vector3d& p_W) {
    EXPECT_EQ(i, indexOf("arm/flange"));
    p_B = window.moment().objects[static_cast<std::size_t>(i)].X_WB.inverse() * p_W;
  });
  const QPointF from = pixelOf("arm/flange");
  mouse(QEvent::MouseButtonPress, from);
  ASSERT_TRUE(p_B.allFinite());
  for (const QPointF& way : {QPointF(-10, 5), QPointF(-25, 12), QPointF(-15, 25)}) {
    mouse(QEvent::MouseMove, from + way);
    ASSERT_TRUE(shows());
    const QPointF at = window.viewport().project(object("arm/flange").X_WB * p_B);
    EXPECT_LE(std::hypot(at.x() - from.x() - way.x(), at.y() - from.y() - way.y()), 1.0);
  }
  mouse(QEvent::MouseButtonRelease, from);
}

TEST_F(StudioDrag, PullOutOfReachIsSaidAndKeepsLimits) {
  const QPointF from = pixelOf("arm/flange");
  mouse(QEvent::MouseButtonPress, from);
  mouse(QEvent::MouseMove, from + QPointF(4000.0, -3000.0));
  expectWithinLimits();
  EXPECT_TRUE(window.statusBar()->currentMessage().startsWith("Out of reach by"))
      << window.statusBar()->currentMessage().toStdString();
  mouse(QEvent::MouseButtonRelease, from);
}

TEST_F(StudioDrag, OnlyMovedLinksAreHeld) {
  mouse(QEvent::MouseButtonPress, pixelOf("anna/head"));
  mouse(QEvent::MouseMove, pixelOf("anna/head") + QPointF(20, 0));
  mouse(QEvent::MouseButtonRelease, pixelOf("anna/head"));
  EXPECT_TRUE(work().posed.isEmpty());
  EXPECT_EQ(window.statusBar()->currentMessage(), "Only links of robots can be moved");
  window.selection().setObjects({indexOf("arm/base")});
  window.actions()[ActionId::kLinkUp]->trigger();
  EXPECT_TRUE(work().posed.isEmpty());
  EXPECT_EQ(window.statusBar()->currentMessage(), "No joint moves this link");
  window.selection().clear();
  window.actions()[ActionId::kLinkUp]->trigger();
  EXPECT_EQ(window.statusBar()->currentMessage(), "Select one link of a robot, or one thing, first");
}

TEST_F(StudioDrag, KeysMoveLinkInView) {
  // Bent first: a stretched arm cannot move in all directions.
  window.document().edit("bend", [&](ui::Work& w) {
    w.posed["arm"] = QVector<double>(static_cast<int>(outline.joints.size()), 0.6);
  });
  ASSERT_TRUE(shows());
  const std::pair<ActionId, Vector3d> keys[] = {
      {ActionId::kLinkRight, Vector3d::UnitX()},  {ActionId::kLinkLeft, -Vector3d::UnitX()},
      {ActionId::kLinkDown, Vector3d::UnitY()},   {ActionId::kLinkUp, -Vector3d::UnitY()},
      {ActionId::kLinkNearer, Vector3d::UnitZ()}, {ActionId::kLinkFarther, -Vector3d::UnitZ()}};
  for (const auto& [id, direction] : keys) {
    const Vector3d before = object("arm/flange").p_WCom;
    window.actions()[id]->trigger();
    ASSERT_TRUE(shows());
    expectWithinLimits();
    const Vector3d moved = object("arm/flange").p_WCom - before;
    EXPECT_LE((moved - 0.01 * window.viewport().fromScreen(direction)).norm(), kReached)
        << window.actions()[id]->text().toStdString();
  }
}

}  // namespace studio_drag_test
}  // namespace abstand::studio
