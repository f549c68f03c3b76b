// The inspector in the window: what it shows, and robots and people that are changed with it.
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QToolButton>
#include <QTreeWidget>
#include <cmath>

#include "core/base/number.hpp"
#include "tests/ui/shown_window.hpp"
#include "ui/document/document.hpp"
#include "ui/document/project_file.hpp"
#include "ui/model/selection.hpp"
#include "ui/panels/inspector_panel.hpp"
#include "ui/panels/joint_editor.hpp"
#include "ui/panels/joint_row.hpp"
#include "ui/panels/person_editor.hpp"
#include "ui/style/actions.hpp"
#include "ui/style/format.hpp"

namespace abstand::ui {
namespace inspector_test {

struct InspectorTest : ShownWindow {
  void SetUp() override {
    ShownWindow::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    panel = window.panels().inspector;
    QApplication::setActiveWindow(&window);
    QTest::keyClick(&window, Qt::Key_7, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !panel->visibleRegion().isEmpty(); }, kWaitMs));
    session.log.clear();
  }
  std::vector<int> groupOf(const std::string& name) const {
    std::vector<int> all;
    for (int i = 0; i < static_cast<int>(session.outline().objects.size()); ++i)
      if (session.outline().objects[static_cast<std::size_t>(i)].group == name) all.push_back(i);
    return all;
  }
  QString value(const char* name) const {
    for (int i = 0; i < panel->rows()->topLevelItemCount(); ++i)
      if (panel->rows()->topLevelItem(i)->text(0) == QLatin1String(name))
        return panel->rows()->topLevelItem(i)->text(1);
    return QStringLiteral("no row");
  }
  QSlider* slider(int joint) { return panel->joints()->row(joint)->findChild<QSlider*>(); }
  QDoubleSpinBox* box(int joint) { return panel->joints()->row(joint)->findChild<QDoubleSpinBox*>(); }
  const Work& work() const { return window.document().work(); }

  InspectorPanel* panel{nullptr};
};

TEST_F(InspectorTest, ShowsDrawnMoment) {
  window.selection().setObjects({session.indexOf("arm/link3")});
  EXPECT_EQ(panel->title()->text(), "arm/link3");
  QStringList seen;
  for (const double t : {0.3, 1.1, 2.9}) {
    session.seek(t);
    window.pull();
    const Vector3d p =
        window.moment().objects[static_cast<std::size_t>(session.indexOf("arm/link3"))].X_WB.translation();
    EXPECT_EQ(value("Position"),
              QStringLiteral("x %1, y %2, z %3 m").arg(fixed(p.x(), 3), fixed(p.y(), 3), fixed(p.z(), 3)));
    EXPECT_EQ(panel->shownStep(), window.moment().step);
    EXPECT_EQ(window.viewport().shownStep(), window.moment().step);
    seen << value("Position");
  }
  EXPECT_NE(seen[0], seen[1]);
  EXPECT_NE(seen[1], seen[2]);
}

TEST_F(InspectorTest, HiddenInspectorIsIdleAndCatchesUp) {
  window.selection().setObjects({session.indexOf("ball")});
  const long before = panel->shownStep();
  auto* plots = window.findChild<QDockWidget*>(QStringLiteral("plots"));
  plots->raise();
  ASSERT_TRUE(QTest::qWaitFor([&] { return panel->visibleRegion().isEmpty(); }, kWaitMs));
  session.seek(1.0);
  window.pull();
  EXPECT_EQ(panel->shownStep(), before);
  window.findChild<QDockWidget*>(QStringLiteral("inspector"))->raise();
  ASSERT_TRUE(QTest::qWaitFor([&] { return panel->shownStep() == window.moment().step; }, kWaitMs));
}

TEST_F(InspectorTest, ShowsEditorsForRobotsAndPeopleOnly) {
  window.selection().setObjects({session.indexOf("ball")});
  EXPECT_FALSE(panel->joints()->isVisible());
  EXPECT_FALSE(panel->person()->isVisible());
  window.selection().setObjects({session.indexOf("arm/link1")});
  EXPECT_TRUE(panel->joints()->isVisible());
  window.selection().setObjects(groupOf("operator"));
  EXPECT_FALSE(panel->joints()->isVisible());
  EXPECT_TRUE(panel->person()->isVisible());
  window.selection().clear();
  EXPECT_FALSE(panel->person()->isVisible());
  EXPECT_EQ(panel->rows()->topLevelItemCount(), 0);
  window.setSession(nullptr);
  EXPECT_EQ(panel->subject().kind, SubjectKind::kNone);
}

TEST_F(InspectorTest, RobotIsPosedByHandAndReleased) {
  session.seek(1.0);
  window.pull();
  window.selection().setObjects(groupOf("arm"));
  const std::vector<double> before = window.moment().joint_positions;
  EXPECT_NEAR(box(2)->value(), before[2] * 180.0 / kPi, 0.051) << "the sliders show the robot";
  EXPECT_FALSE(panel->joints()->followButton()->isEnabled());
  session.log.clear();
  box(1)->setValue(-30.0);
  ASSERT_EQ(session.log.size(), 5u) << "all joints: the others stay where they are";
  EXPECT_EQ(session.log[1], "pose 1 -0.523599");
  window.pull();
  for (std::size_t k = 0; k < before.size(); ++k)
    EXPECT_NEAR(window.moment().joint_positions[k], k == 1 ? -kPi / 6.0 : before[k], 1e-12);
  EXPECT_EQ(value("Motion"), "posed by hand");
  EXPECT_TRUE(window.windowTitle().contains("arm posed by hand")) << window.windowTitle().toStdString();
  EXPECT_EQ(panel->findChild<QLabel*>("joints_state")->text(), "arm is posed by hand");
  // The clock goes on for everything else.
  const auto ball = static_cast<std::size_t>(session.indexOf("ball"));
  const Vector3d was = window.moment().objects[ball].p_WCom;
  session.seek(1.7);
  window.pull();
  EXPECT_NE(window.moment().objects[ball].p_WCom, was);
  EXPECT_NEAR(window.moment().joint_positions[1], -kPi / 6.0, 1e-12);
  panel->joints()->followButton()->click();
  EXPECT_EQ(session.log.back(), "follow 0");
  window.pull();
  EXPECT_FALSE(window.moment().movers.by_hand[0]);
  EXPECT_FALSE(window.windowTitle().contains("by hand"));
  EXPECT_TRUE(work().posed.isEmpty());
  window.actions()[ActionId::kUndo]->trigger();
  window.pull();
  EXPECT_TRUE(window.moment().movers.by_hand[0]);
  EXPECT_NEAR(window.moment().joint_positions[1], -kPi / 6.0, 1e-12);
}

TEST_F(InspectorTest, SliderDragIsOneStepWithinLimits) {
  window.selection().setObjects(groupOf("arm"));
  const int steps = window.document().steps().count();
  slider(3)->setSliderDown(true);
  for (const int tenths : {100, 250, 300}) slider(3)->setValue(tenths);
  slider(3)->setSliderDown(false);
  EXPECT_EQ(window.document().steps().count(), steps + 1);
  EXPECT_NEAR(work().posed.value("arm")[3], kPi / 6.0, 1e-12);
  slider(3)->setValue(slider(3)->maximum());
  EXPECT_EQ(work().posed.value("arm")[3], kPi) << "exactly, not rounded to a tenth of a degree";
  EXPECT_EQ(slider(3)->minimum(), -1800);
  window.actions()[ActionId::kUndo]->trigger();
  EXPECT_NEAR(work().posed.value("arm")[3], kPi / 6.0, 1e-12);
  EXPECT_NEAR(box(3)->value(), 30.0, 1e-9);
  window.actions()[ActionId::kUndo]->trigger();
  EXPECT_TRUE(work().posed.isEmpty());
  EXPECT_EQ(session.log.back(), "follow 0");
}

TEST_F(InspectorTest, ProjectKeepsPose) {
  window.selection().setObjects(groupOf("arm"));
  box(0)->setValue(12.0);
  const std::string text = projectText(window.document().project(), {});
  const Project read = parseProject(text, "p.abstand", {}).project;
  EXPECT_EQ(read.work.posed, work().posed);
  FakeSession other;
  window.setSession(nullptr);
  window.document().open(read, {}, false);
  window.setSession(&other);
  window.pull();
  EXPECT_TRUE(window.moment().movers.by_hand[0]);
  EXPECT_NEAR(window.moment().joint_positions[0], 12.0 * kPi / 180.0, 1e-12);
  window.setSession(&session);
}

TEST_F(InspectorTest, RequestsPersonWithTickedOptions) {
  qRegisterMetaType<PersonOptions>("abstand::ui::PersonOptions");
  const QSignalSpy asked(&window, &MainWindow::personRequested);
  window.selection().setObjects({session.indexOf("operator/head")});
  auto* apply = panel->person()->findChild<QPushButton*>("rebuild_person");
  EXPECT_FALSE(apply->isEnabled()) << "nothing differs";
  EXPECT_NEAR(panel->person()->findChild<QDoubleSpinBox*>("stature")->value(), 1.78, 1e-9);
  panel->person()->findChild<QCheckBox*>("percentile_on")->click();
  panel->person()->findChild<QDoubleSpinBox*>("percentile")->setValue(95.0);
  panel->person()->findChild<QComboBox*>("sex")->setCurrentIndex(1);
  ASSERT_TRUE(apply->isEnabled());
  apply->click();
  ASSERT_EQ(asked.size(), 1);
  EXPECT_EQ(asked[0][0].toString(), "operator");
  const PersonOptions wanted{std::nullopt, 95.0, std::nullopt, QStringLiteral("f")};
  EXPECT_EQ(asked[0][1].value<PersonOptions>(), wanted);
  EXPECT_TRUE(work().people.isEmpty()) << "an edit once the person is there";
  window.document().edit("person", [&](Work& w) { w.people["operator"] = wanted; });
  EXPECT_FALSE(apply->isEnabled());
  EXPECT_TRUE(panel->person()->findChild<QCheckBox*>("percentile_on")->isChecked());
  EXPECT_FALSE(panel->person()->findChild<QCheckBox*>("mass_on")->isChecked());
  panel->person()->findChild<QCheckBox*>("percentile_on")->click();
  apply->click();
  ASSERT_EQ(asked.size(), 2);
  EXPECT_EQ(asked[1][1].value<PersonOptions>(),
            (PersonOptions{std::nullopt, std::nullopt, std::nullopt, QStringLiteral("f")}));
}

TEST_F(InspectorTest, ThePoseOfARobotIsCopied) {
  window.selection().setObjects(groupOf("arm"));
  session.seek(1.3);
  window.pull();
  const auto copy = [this](int entry) {
    panel->joints()->copyButton()->menu()->actions().at(entry)->trigger();
    return QApplication::clipboard()->text();
  };
  const QVector<double> q(window.moment().joint_positions.begin(), window.moment().joint_positions.end());
  QStringList numbers;
  for (const double value : q) numbers << QString::fromStdString(formatDouble(value));
  EXPECT_EQ(copy(1), "q: [" + numbers.join(", ") + "]");
  EXPECT_EQ(copy(2), "{" + numbers.join(", ") + "}");
  EXPECT_TRUE(copy(0).startsWith("{\"joint1\": " + numbers[0] + ", \"joint2\": "));
}

}  // namespace inspector_test
}  // namespace abstand::ui
