// Where people, robots and things stand: by default, by numbers, and by handles in the 3D view.
#include <QAction>
#include <QDoubleSpinBox>
#include <QMouseEvent>
#include <QPushButton>
#include <QStatusBar>
#include <QTreeWidget>
#include <cmath>

#include "app/depth/open_session.hpp"
#include "app/studio/default_placement.hpp"
#include "tests/ui/studio_window.hpp"
#include "ui/document/project_file.hpp"
#include "ui/file_commands.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/selection.hpp"
#include "ui/panels/inspector_panel.hpp"
#include "ui/panels/note_panel.hpp"
#include "ui/panels/placement_editor.hpp"
#include "ui/style/actions.hpp"
#include "ui/thing_drag.hpp"
#include "ui/viewport/opengl.hpp"
#include "ui/viewport/overlay.hpp"

namespace abstand::studio {
namespace studio_place_test {

using ui::ActionId;
using ui::Handles;
using Kind = ui::PlacementEditor::Kind;

constexpr char kPost[] =
    "<robot name='r'><link name='a'><collision><geometry><box size='0.2 0.4 1'/></geometry>"
    "</collision></link></robot>";
constexpr double kSame = 1e-9;           // m, rad: mm and degrees and back
constexpr double kRoundedPlace = 0.011;  // m: places are rounded to centimetres
constexpr double kRoundedTurn = kPi / 180.0;

struct StudioPlace : StudioWindow {
  StudioPlace() {
    folder.write("post.urdf", kPost);
    writeUpright("turn.csv", 0.3);
    writeUpright("walk.csv", 0.0);
  }
  bool opensAll(std::initializer_list<const char*> names) {
    QStringList files;
    for (const char* name : names) files << in(name);
    return opens([&] { window.files().open(files); });
  }
  ui::PlacementEditor* editor() const { return window.panels().inspector->placement(); }
  QAction* action(ActionId id) const { return window.actions()[id]; }
  const view::ObjectSnapshot& object(int i) const {
    return window.moment().objects[static_cast<std::size_t>(i)];
  }
  /// Index of the body in the tree's order of the scene that `scene.yaml` describes: 14 parts, then the wall.
  static constexpr int kWall = 14;
  bool showsWallAt(const Vector3d& p_W) {
    return QTest::qWaitFor(
        [&] {
          window.pull();
          return (object(kWall).X_WB.translation() - p_W).norm() < kSame;
        },
        kLoadMs);
  }
};

TEST_F(StudioPlace, PersonStandsInFrontOfRobotAndFacesIt) {
  ASSERT_TRUE(opensAll({"post.urdf", "turn.csv"})) << problem;
  ASSERT_TRUE(work().placed.contains("person"));
  EXPECT_FALSE(window.document().modified()) << "it is how the files are shown";
  EXPECT_TRUE(window.statusBar()->currentMessage().startsWith("person was placed in front of robot"))
      << window.statusBar()->currentMessage().toStdString();
  EXPECT_EQ(window.panels().notes->topLevelItem(0)->text(1), "placement");
  window.pull();
  // The post is the first body and ends at x = 0.1; the torso is the second.
  EXPECT_NEAR(object(0).X_WB.translation().norm(), 0.0, kSame);
  const Vector3d torso = object(1).X_WB.translation();
  EXPECT_GT(torso.x(), 0.1 + kPersonGap);
  constexpr double kWay = 0.19;  // m, that the person goes on towards the robot
  EXPECT_LT(torso.x(), 0.1 + kPersonGap + kWay + 0.5) << "half of a person's depth, and arms";
  EXPECT_NEAR(torso.y(), 0.0, kRoundedPlace);
  const Vector3d faces = object(1).X_WB.linear().col(0);
  EXPECT_NEAR(std::atan2(faces.y(), -faces.x()), 0.0, kRoundedTurn);
  const auto nearest = [&] {
    double distance = kInfinity;
    for (const view::PairSnapshot& pair : window.moment().pairs)
      distance = std::min(distance, pair.result.distance);
    return distance;
  };
  EXPECT_GE(nearest(), kPersonGap + kWay - kRoundedPlace);
  window.playback().toEnd();
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        window.pull();
        return window.moment().t > 1.85;
      },
      kLoadMs));
  EXPECT_GE(nearest(), kPersonGap - kRoundedPlace) << "no nearer in the whole recording";
  EXPECT_LT(nearest(), kPersonGap + 0.1) << "boxes of the bodies decide, not their surfaces";
}

TEST_F(StudioPlace, RobotsOfSeveralFilesStandBesideEachOther) {
  folder.write("second.urdf", kPost);
  folder.write("third.urdf", kPost);
  ASSERT_TRUE(opensAll({"post.urdf", "second.urdf", "third.urdf", "turn.csv"})) << problem;
  EXPECT_EQ(work().placed.keys(), QStringList({"person", "second", "third"})) << "the first stays";
  window.pull();
  // Posts of 0.4 m along y.
  constexpr double kCentimetre = 0.01;  // they are rounded up to
  for (const auto& [name, y] : {std::pair("second", 0.6), std::pair("third", 1.2)}) {
    EXPECT_GE(work().placed.value(name).xyz.y(), y - kSame) << name;
    EXPECT_LE(work().placed.value(name).xyz.y(), y + 2.0 * kCentimetre) << name;
  }
  double nearest = kInfinity;
  for (const view::PairSnapshot& pair : window.moment().pairs)
    nearest = std::min(nearest, pair.result.distance);
  EXPECT_GE(nearest, kRobotGap - 1e-3) << "but for the bound of a distance";
  // Undone together with what was opened: it is no edit of its own.
  EXPECT_FALSE(window.document().steps().canUndo());
}

TEST_F(StudioPlace, PlaceOfPersonIsChangedInInspectorAndStored) {
  ASSERT_TRUE(opensAll({"post.urdf", "turn.csv"})) << problem;
  const ui::Placement by_default = work().placed.value("person");
  window.selection().setObjects({1});
  window.panels().inspector->setInFront(true);
  ASSERT_EQ(editor()->kind(), Kind::kPerson);
  EXPECT_EQ(editor()->name(), "person");
  EXPECT_FALSE(editor()->box(3)->isVisibleTo(editor())) << "a person only turns about z";
  EXPECT_NEAR(editor()->box(0)->value(), 1e3 * by_default.xyz.x(), 0.5);
  const double x = object(1).X_WB.translation().x();
  window.playback().seek(1.0);
  ASSERT_TRUE(opens([&] { editor()->box(0)->setValue(1e3 * by_default.xyz.x() + 250.0); })) << problem;
  EXPECT_NEAR(window.playback().time(), 1.0, 0.06) << "the clock stays";
  window.playback().seek(0.0);
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        window.pull();
        return std::abs(object(1).X_WB.translation().x() - x - 0.25) < 1e-3;
      },
      kLoadMs));
  EXPECT_NE(window.panels().notes->topLevelItem(0) ? window.panels().notes->topLevelItem(0)->text(1) : "",
            "placement")
      << "the user has said where";
  ui::writeProject(window.document().project(), in("p.abstand"));
  const ui::Placement moved = work().placed.value("person");
  ASSERT_TRUE(opens([&] { action(ActionId::kUndo)->trigger(); })) << problem;
  EXPECT_EQ(work().placed.value("person"), by_default);
  EXPECT_EQ(window.panels().notes->topLevelItem(0)->text(1), "placement");
  window.document().setSaved(in("p.abstand"));
  ASSERT_TRUE(opensAll({"p.abstand"})) << problem;
  EXPECT_EQ(work().placed.value("person"), moved);
  // As in its file.
  window.selection().setObjects({1});
  ASSERT_TRUE(opens([&] { editor()->resetButton()->click(); })) << problem;
  EXPECT_TRUE(work().placed.isEmpty());
  window.playback().seek(0.0);
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        window.pull();
        return std::abs(object(1).X_WB.translation().x() - 0.3) < 1e-6;
      },
      kLoadMs));
}

TEST_F(StudioPlace, RobotIsPlacedByNumbers) {
  folder.write("cell.yaml",
               "abstand: 1\ndefaults: {voxel: 0.1, point: 0.1}\nmechanisms:\n"
               "  - {name: post, file: post.urdf, base: {xyz: [0, 1, 0], rpy: [0, 0, 0.5]}}\n"
               "humans:\n  - {name: anna, recording: {file: walk.csv, place: {xyz: [2, 0, 0]}}}\n");
  ASSERT_TRUE(opensAll({"cell.yaml"})) << problem;
  EXPECT_TRUE(work().placed.isEmpty()) << "the scene says where";
  window.selection().setObjects({0});
  window.panels().inspector->setInFront(true);
  ASSERT_EQ(editor()->kind(), Kind::kRobot);
  EXPECT_NEAR(editor()->box(1)->value(), 1000.0, kSame);
  EXPECT_NEAR(editor()->box(5)->value(), 0.5 * 180.0 / kPi, 0.06) << "shown with one decimal";
  EXPECT_FALSE(editor()->resetButton()->isEnabled());
  ASSERT_TRUE(opens([&] { editor()->box(2)->setValue(800.0); })) << problem;
  window.pull();
  EXPECT_NEAR(object(0).X_WB.translation().z(), 0.8, kSame);
  EXPECT_NEAR(std::atan2(object(0).X_WB.linear()(1, 0), object(0).X_WB.linear()(0, 0)), 0.5, kSame)
      << "other numbers stay exact";
  ASSERT_TRUE(opens([&] { action(ActionId::kUndo)->trigger(); })) << problem;
  window.pull();
  EXPECT_NEAR(object(0).X_WB.translation().z(), 0.0, kSame);
}

TEST_F(StudioPlace, ThingIsMovedByNumbersAtOnce) {
  ASSERT_TRUE(opensAll({"scene.yaml"})) << problem;
  const QSignalSpy ready(&studio, &Studio::ready);
  window.selection().setObjects({kWall});
  window.panels().inspector->setInFront(true);
  window.pull();
  window.panels().inspector->refresh(window.moment());
  ASSERT_EQ(editor()->kind(), Kind::kThing);
  EXPECT_NEAR(editor()->box(0)->value(), -1000.0, kSame);
  const auto nearest = [&] {
    return window.moment().pairs[static_cast<std::size_t>(window.moment().nearest_pair)].result.distance;
  };
  const double before = nearest();
  editor()->box(0)->setValue(-1500.0);
  ASSERT_TRUE(showsWallAt({-1.5, 0.0, 1.0}));
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        window.pull();
        return std::abs(nearest() - before - 0.5) < 1e-6;
      },
      kLoadMs))
      << nearest() - before;
  EXPECT_NEAR(object(kWall).velocity.linear.norm(), 0.0, kSame) << "it was put there, and does not move";
  editor()->box(5)->setValue(90.0);
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        window.pull();
        return std::abs(object(kWall).X_WB.linear()(1, 0) - 1.0) < kSame;
      },
      kLoadMs));
  EXPECT_TRUE(ready.isEmpty()) << "nothing is loaded for it";
  ui::writeProject(window.document().project(), in("p.abstand"));
  const auto moved = work().things;
  action(ActionId::kUndo)->trigger();
  action(ActionId::kUndo)->trigger();
  EXPECT_TRUE(work().things.isEmpty());
  ASSERT_TRUE(showsWallAt({-1.0, 0.0, 1.0}));
  window.document().setSaved(in("p.abstand"));
  ASSERT_TRUE(opensAll({"p.abstand"})) << problem;
  EXPECT_EQ(work().things, moved);
  ASSERT_TRUE(showsWallAt({-1.5, 0.0, 1.0}));
}

struct StudioHandles : StudioPlace {
  void SetUp() override {
    if (!ui::openGlInfo().available) GTEST_SKIP() << "no OpenGL 3.2 here";
    ASSERT_TRUE(opensAll({"scene.yaml"})) << problem;
    for (QWidget* child : window.viewport().findChildren<QWidget*>())
      if (child->accessibleName() == QStringLiteral("3D view")) canvas = child;
    ASSERT_TRUE(canvas);
    action(ActionId::kIso)->trigger();
    window.selection().setObjects({kWall});
    QTest::qWait(100);
    window.pull();
    ASSERT_TRUE(handles());
  }
  const std::optional<Handles::Drawing>& handles() const {
    window.viewport().picture();
    return window.viewport().overlay().content().handles;
  }
  void mouse(QEvent::Type type, const QPointF& at) {
    QMouseEvent event(type, at.toPoint(), type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
                      type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(canvas, &event);
  }
  void drag(const QPointF& from, const QPointF& way) {
    mouse(QEvent::MouseButtonPress, from);
    for (int k = 1; k <= 8; ++k) mouse(QEvent::MouseMove, from + k / 8.0 * way);
    mouse(QEvent::MouseButtonRelease, from + way);
  }
  ui::Placement wall() const { return work().things.value("wall"); }
  QWidget* canvas{nullptr};
};

TEST_F(StudioHandles, ArrowMovesThingAlongItsAxisInOneStep) {
  const int steps = window.document().steps().index();
  const ui::CameraView camera = window.viewport().cameraView();
  const Handles::Drawing shown = *handles();
  const QPointF along = shown.tips[1] - shown.centre;
  drag(shown.centre + 0.7 * along, 0.5 * along);
  EXPECT_EQ(window.document().steps().index(), steps + 1);
  EXPECT_EQ(window.viewport().cameraView(), camera) << "the camera stays";
  EXPECT_EQ(window.selection().objects(), std::vector<int>{kWall});
  // Half an arrow, whose length is that of kLength pixels seen from the side.
  const Vector3d right = window.viewport().fromScreen(Vector3d::UnitX());
  const Vector3d at(-1.0, 0.0, 1.0);
  const QPointF metre = window.viewport().project(at + 0.01 * right) - window.viewport().project(at);
  const double expected = 0.5 * Handles::kLength / (std::hypot(metre.x(), metre.y()) / 0.01);
  constexpr double kPixel = 1.5;  // px: the mouse has whole ones
  EXPECT_NEAR(wall().xyz.y(), expected, kPixel * expected / (0.5 * std::hypot(along.x(), along.y())));
  EXPECT_NEAR(wall().xyz.x(), -1.0, kSame);
  EXPECT_NEAR(wall().xyz.z(), 1.0, kSame);
  ASSERT_TRUE(showsWallAt(wall().xyz));
  EXPECT_NEAR(handles()->centre.x(), shown.centre.x() + 0.5 * along.x(), 3.0) << "the handles follow";
  // Another drag is another step.
  drag(handles()->centre + 0.7 * (handles()->tips[2] - handles()->centre), QPointF(0.0, -40.0));
  EXPECT_GT(wall().xyz.z(), 1.05);
  EXPECT_EQ(window.document().steps().index(), steps + 2);
  action(ActionId::kUndo)->trigger();
  action(ActionId::kUndo)->trigger();
  EXPECT_TRUE(work().things.isEmpty());
  ASSERT_TRUE(showsWallAt({-1.0, 0.0, 1.0}));
}

TEST_F(StudioHandles, KeysMoveThingAlongTheNearestAxis) {
  constexpr double kStep = ui::ThingDrag::kStep;
  const int steps = window.document().steps().index();
  action(ActionId::kFront)->trigger();
  QTest::qWait(50);
  const Vector3d right = window.viewport().fromScreen(Vector3d::UnitX());
  action(ActionId::kLinkRight)->trigger();
  Eigen::Index axis = 0;
  EXPECT_NEAR(right.cwiseAbs().maxCoeff(&axis), 1.0, 1e-6) << "the front view looks along an axis";
  Vector3d expected(-1.0, 0.0, 1.0);
  expected[axis] += std::copysign(kStep, right[axis]);
  EXPECT_LT((wall().xyz - expected).norm(), kSame);
  ASSERT_TRUE(showsWallAt(expected));
  action(ActionId::kLinkUp)->trigger();
  expected.z() += kStep;
  EXPECT_LT((wall().xyz - expected).norm(), kSame);
  EXPECT_EQ(window.document().steps().index(), steps + 2) << "each is a step of its own";
  action(ActionId::kUndo)->trigger();
  action(ActionId::kUndo)->trigger();
  EXPECT_TRUE(work().things.isEmpty());
}

TEST_F(StudioHandles, RingTurnsThingAboutTheVertical) {
  const Handles::Drawing shown = *handles();
  ASSERT_GT(shown.ring.size(), 12u);
  // A quarter of the ring, from 22 to 112 degrees, where no arrow is.
  const QPointF from = shown.ring[3], to = shown.ring[15];
  mouse(QEvent::MouseButtonPress, from);
  mouse(QEvent::MouseMove, shown.ring[9]);
  mouse(QEvent::MouseMove, to);
  mouse(QEvent::MouseButtonRelease, to);
  constexpr double kTwoDegrees = kPi / 90.0;  // the mouse has whole pixels
  EXPECT_NEAR(wall().rpy.z(), 0.5 * kPi, kTwoDegrees);
  EXPECT_NEAR((wall().xyz - Vector3d(-1.0, 0.0, 1.0)).norm(), 0.0, 1e-6) << "about its own centre";
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        window.pull();
        return object(kWall).X_WB.isApprox(wall().X_W(), kSame);
      },
      kLoadMs));
}

TEST_F(StudioHandles, LabelsKeepOffTheTips) {
  const Handles::Drawing shown = *handles();
  const std::vector<ui::PlacedLabel> labels = window.viewport().overlay().placeLabels();
  ASSERT_FALSE(labels.empty()) << "the selection has a name";
  for (const ui::PlacedLabel& label : labels)
    for (const QPointF& tip : shown.tips)
      EXPECT_FALSE(label.box.contains(tip)) << label.label.text.toStdString();
}

TEST_F(StudioHandles, OnlyThingsHaveHandles) {
  window.selection().setObjects({0});
  EXPECT_FALSE(handles());
  window.selection().setObjects({kWall, 0});
  EXPECT_FALSE(handles());
  window.selection().setObjects({kWall});
  EXPECT_TRUE(handles());
  window.selection().clear();
  EXPECT_FALSE(handles());
  // Beside a handle the camera orbits.
  window.selection().setObjects({kWall});
  const ui::CameraView camera = window.viewport().cameraView();
  drag(handles()->centre + QPointF(-160.0, 120.0), QPointF(30.0, 10.0));
  EXPECT_FALSE(window.viewport().cameraView() == camera);
  EXPECT_TRUE(work().things.isEmpty());
}

/// Whatever base and recording: the person is in front of the base and looks at it.
TEST(DefaultPlacementTest, FollowsBaseAndHeading) {
  testing::ScratchFolder folder;
  folder.write("post.urdf", kPost);
  for (const double base : {0.0, 1.1, -2.5})
    for (const double person : {0.0, 2.0, -1.3}) {
      SCOPED_TRACE(std::to_string(base) + " " + std::to_string(person));
      // Pelvis, neck and hips: the hips tell the heading.
      std::string text = "t";
      for (const char* joint : {"pelvis", "neck", "hip_left", "hip_right", "shoulder_left", "shoulder_right"})
        for (const char* axis : {".x", ".y", ".z"}) text += std::string(",") + joint + axis;
      for (int i = 0; i < 3; ++i) {
        text += "\n" + std::to_string(0.1 * i);
        const auto add = [&](double left, double z) {
          const Vector3d at = Vector3d(3.0, -2.0, z) +
                              Eigen::AngleAxisd(person, Vector3d::UnitZ()) * Vector3d(0.0, left, 0.0);
          for (const double x : at) text += "," + std::to_string(x);
        };
        add(0.0, 1.0), add(0.0, 1.5), add(0.1, 0.95), add(-0.1, 0.95), add(0.2, 1.45), add(-0.2, 1.45);
      }
      folder.write("walk.csv", text + "\n");
      const auto scene = folder.write(
          "scene.yaml",
          "abstand: 1\ndefaults: {voxel: 0.1, point: 0.1}\nmechanisms:\n"
          "  - {name: post, file: post.urdf, base: {xyz: [1, 2, 0.5], rpy: [0, 0, " +
              std::to_string(base) + "]}}\nhumans:\n  - {name: anna, recording: {file: walk.csv}}\n");
      session::SessionOptions options;
      options.cache = false;
      options.threads = 1;
      const auto session = depth::openSession(scene_file::loadScene(scene), options);
      const auto found = defaultPlacement(*session);
      ASSERT_TRUE(found);
      session->placePerson(0, found->placement.xyz, found->placement.rpy.z());
      session->step(0.0);
      const Transform& torso = session->scene().find("anna/torso")->X_WB;
      const Vector3d front = Eigen::AngleAxisd(base, Vector3d::UnitZ()) * Vector3d::UnitX();
      const Vector3d stands = torso.translation() - Vector3d(1.0, 2.0, torso.translation().z());
      EXPECT_NEAR(stands.cross(front).z(), 0.0, 2.0 * kRoundedPlace) << "on the axis of the base";
      EXPECT_GT(stands.dot(front), 0.1 + kPersonGap);
      EXPECT_LT(torso.linear().col(0).dot(front), -std::cos(1.5 * kRoundedTurn)) << "faces the robot";
      double nearest = kInfinity;
      for (const scene::Pair& pair : session->scene().pairs())
        nearest = std::min(nearest, pair.result.distance);
      EXPECT_NEAR(nearest, kPersonGap, 0.1) << "boxes of the bodies decide, not their surfaces";
      EXPECT_GE(nearest, kPersonGap - kRoundedPlace);
      EXPECT_TRUE(isSame(defaultPlacement(*session)->placement, found->placement)) << "and stays there";
    }
}

}  // namespace studio_place_test
}  // namespace abstand::studio
