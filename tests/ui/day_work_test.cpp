// What a working day needs besides the panels: units, log, history, views, the start page, the tour.
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QLabel>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTreeWidget>
#include <cmath>
#include <memory>

#include "tests/ui/fake_analysis.hpp"
#include "tests/ui/modal_answer.hpp"
#include "tests/ui/shown_window.hpp"
#include "ui/document/document.hpp"
#include "ui/document/project_file.hpp"
#include "ui/model/recent_files.hpp"
#include "ui/model/selection.hpp"
#include "ui/panels/history_panel.hpp"
#include "ui/panels/inspector_panel.hpp"
#include "ui/panels/joint_editor.hpp"
#include "ui/panels/joint_row.hpp"
#include "ui/panels/lane_view.hpp"
#include "ui/panels/log_panel.hpp"
#include "ui/panels/margin_panel.hpp"
#include "ui/panels/margin_row.hpp"
#include "ui/panels/pair_panel.hpp"
#include "ui/panels/scene_tree_panel.hpp"
#include "ui/panels/separation_chart.hpp"
#include "ui/panels/separation_panel.hpp"
#include "ui/panels/start_page.hpp"
#include "ui/panels/timeline_panel.hpp"
#include "ui/panels/tour.hpp"
#include "ui/plots/plot_panel.hpp"
#include "ui/plots/strip_chart.hpp"
#include "ui/style/actions.hpp"
#include "ui/style/format.hpp"

namespace abstand::ui {
namespace day_work_test {

struct DayWorkTest : ShownWindow {
  void TearDown() override {
    for (const ActionId id : {ActionId::kMetres, ActionId::kRadians}) window.actions()[id]->setChecked(false);
  }
  QDockWidget* dock(const char* name) { return window.findChild<QDockWidget*>(QString::fromLatin1(name)); }
  void bring(const char* name) {
    dock(name)->show();
    dock(name)->raise();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !dock(name)->visibleRegion().isEmpty(); }, kWaitMs));
  }
  StripChart* chart() { return window.panels().plots->charts().front(); }
};

TEST_F(DayWorkTest, LengthsAreShownInMetresAndDataStay) {
  const int hand = session.indexOf("operator/hand_left");
  MarginRow* row = window.panels().margins->row(hand);
  auto* box = row->findChild<QDoubleSpinBox*>();
  ASSERT_EQ(box->text(), "40 mm");
  const QTableView* table = window.panels().pairs->table();
  const auto title = [&] { return table->model()->headerData(3, Qt::Horizontal).toString(); };
  const QString before = table->model()->index(0, 3).data().toString();
  const Work work = window.document().work();
  EXPECT_EQ(title(), "Distance [mm]");
  window.actions()[ActionId::kMetres]->setChecked(true);
  EXPECT_EQ(box->text(), "0.040 m");
  EXPECT_EQ(title(), "Distance [m]");
  EXPECT_NEAR(table->model()->index(0, 3).data().toString().toDouble(), 1e-3 * before.toDouble(), 1e-4);
  EXPECT_TRUE(chart()->lineName(0).endsWith("[m]"));
  EXPECT_EQ(chart()->factor(), 1.0);
  EXPECT_TRUE(window.document().work() == work) << "no edit";
  box->setValue(0.125);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window.document().work().margins.isEmpty(); }, kWaitMs));
  EXPECT_NEAR(window.document().work().margins["operator/hand_left"], 0.125, 1e-9);
  window.actions()[ActionId::kMetres]->setChecked(false);
  EXPECT_EQ(box->text(), "125 mm");
  EXPECT_NEAR(row->metres(), 0.125, 1e-9);
}

TEST_F(DayWorkTest, AnglesAreShownInRadiansAndDataStay) {
  bring("inspector");
  InspectorPanel* panel = window.panels().inspector;
  const int link = session.indexOf("arm/link3");
  window.selection().setObjects({link});
  window.pull();
  const auto inspected = [&](const QString& property) {
    for (int i = 0; i < panel->rows()->topLevelItemCount(); ++i)
      if (panel->rows()->topLevelItem(i)->text(0) == property) return panel->rows()->topLevelItem(i)->text(1);
    return QString();
  };
  auto* box = panel->joints()->row(1)->findChild<QDoubleSpinBox*>();
  const double joint = window.moment().joint_positions[1];
  EXPECT_NEAR(box->value(), joint * 180.0 / kPi, 0.051);
  EXPECT_TRUE(box->text().endsWith(QStringLiteral("°")));
  const QString degrees = inspected("Roll, pitch, yaw");
  ASSERT_TRUE(degrees.contains(QStringLiteral("°"))) << degrees.toStdString();
  const Work work = window.document().work();
  window.actions()[ActionId::kRadians]->setChecked(true);
  EXPECT_TRUE(box->text().endsWith(QStringLiteral(" rad"))) << box->text().toStdString();
  EXPECT_NEAR(box->value(), joint, 0.00051);
  EXPECT_NEAR(box->maximum(), session.outline().joints[1].upper, 0.00051);
  window.pull();
  const QStringList shown = inspected("Roll, pitch, yaw").split(QStringLiteral(", ")),
                    before = degrees.split(QStringLiteral(", "));
  ASSERT_EQ(shown.size(), 3);
  for (int k = 0; k < 3; ++k) {
    EXPECT_TRUE(shown[k].endsWith(QStringLiteral(" rad"))) << shown[k].toStdString();
    const double rad = shown[k].chopped(4).toDouble(), deg = before[k].chopped(1).toDouble();
    // Both are rounded: to 0.1 degrees and to 0.001 rad.
    EXPECT_NEAR(rad, deg * kPi / 180.0, 0.5e-3 + 0.05 * kPi / 180.0);
  }
  EXPECT_EQ(angleText(kPi / 2.0), QStringLiteral("1.571 rad"));
  EXPECT_TRUE(window.document().work() == work) << "no edit";
  session.log.clear();
  box->setValue(0.25);
  EXPECT_TRUE(std::find(session.log.begin(), session.log.end(), "pose 1 0.25") != session.log.end());
  EXPECT_NEAR(window.document().work().posed["arm"][1], 0.25, 1e-12) << "rad, as in files";
  window.actions()[ActionId::kRadians]->setChecked(false);
  EXPECT_NEAR(box->value(), 0.25 * 180.0 / kPi, 0.051);
  EXPECT_EQ(angleText(kPi / 2.0), QStringLiteral("90.0°"));
}

TEST_F(DayWorkTest, LayoutsKeepSizeOfWindow) {
  window.resize(1024, 700);
  ASSERT_TRUE(QTest::qWaitFor([&] { return window.size() == QSize(1024, 700); }, kWaitMs));
  for (const ActionId id :
       {ActionId::kResetLayout, ActionId::kLayoutReplay, ActionId::kLayoutReview, ActionId::kLayoutTuning}) {
    window.actions()[id]->trigger();
    QTest::qWait(100);
    EXPECT_EQ(window.size(), QSize(1024, 700)) << window.actions()[id]->text().toStdString();
  }
}

TEST_F(DayWorkTest, MessagesCanBeReadAgain) {
  bring("log");
  window.showProblem("Cannot open", "first line\nsecond line");
  window.actions()[ActionId::kCopyPicture]->trigger();
  QPlainTextEdit* lines = window.panels().log->lines();
  EXPECT_TRUE(lines->toPlainText().contains("Opened made-up: 21 bodies"));
  EXPECT_TRUE(lines->toPlainText().contains("⚠ Cannot open: first line second line"));
  EXPECT_TRUE(lines->toPlainText().contains("clipboard"));
  window.panels().log->onlyProblems()->setChecked(true);
  EXPECT_TRUE(lines->toPlainText().contains("⚠ Cannot open"));
  EXPECT_FALSE(lines->toPlainText().contains("clipboard"));
}

TEST_F(DayWorkTest, TheHistoryGoesBackAndForth) {
  bring("history");
  Document& document = window.document();
  document.edit("one", [](Work& work) { work.margins["operator/head"] = 0.1; });
  document.edit("two", [](Work& work) { work.hidden.insert("ball"); });
  const Work both = document.work();
  HistoryPanel* panel = window.panels().history;
  ASSERT_EQ(panel->model()->rowCount(), 3) << "the state at first, and two edits";
  EXPECT_EQ(panel->model()->index(2, 0).data().toString(), "two");
  panel->setCurrentIndex(panel->model()->index(0, 0));
  EXPECT_TRUE(document.work().margins.isEmpty());
  EXPECT_TRUE(document.work().hidden.isEmpty());
  panel->setCurrentIndex(panel->model()->index(2, 0));
  EXPECT_TRUE(document.work() == both);
}

TEST_F(DayWorkTest, TheSelectionIsThatOfAllPanels) {
  FakeAnalysis analysis(session.outline(),
                        [](std::size_t part, std::size_t) { return 0.1 + 0.01 * static_cast<double>(part); });
  analysis.runAll();
  session.recording = &analysis;
  window.setSession(&session);
  QTest::qWait(200);
  const int hand = session.indexOf("operator/hand_left");
  const std::size_t classes = chart()->lines();
  window.selection().setObjects({hand});
  EXPECT_TRUE(window.panels().margins->row(hand)->marked());
  EXPECT_FALSE(window.panels().margins->row(hand + 1)->marked());
  const LaneView* lanes = window.panels().timeline->laneView();
  for (int lane = 0; lane < lanes->lanes(); ++lane)
    EXPECT_EQ(lanes->isSelected(lane), analysis.layout().parts[static_cast<std::size_t>(lane)].object ==
                                           static_cast<std::size_t>(hand));
  ASSERT_EQ(chart()->lines(), classes + 1);
  EXPECT_TRUE(chart()->lineName(classes).contains("operator/hand_left"));
  window.selection().clear();
  EXPECT_EQ(chart()->lines(), classes);
  EXPECT_FALSE(window.panels().margins->row(hand)->marked());
  window.setSession(nullptr);
}

TEST_F(DayWorkTest, ABodyIsDraggedFromTheTreeToThePlots) {
  const auto* tree = window.findChild<SceneTreePanel*>();
  const QModelIndex link = tree->model()->index(2, 0, tree->model()->index(0, 0));
  const std::unique_ptr<QMimeData> data(tree->model()->mimeData({link}));
  PlotPanel* plots = window.panels().plots;
  const std::size_t classes = chart()->lines();
  QDragEnterEvent enter(QPoint(20, 20), Qt::CopyAction, data.get(), Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(plots, &enter);
  ASSERT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(20, 20), Qt::CopyAction, data.get(), Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(plots, &drop);
  ASSERT_EQ(chart()->lines(), classes + 1);
  EXPECT_TRUE(chart()->lineName(classes).contains("arm/link2"));
  session.seek(3.0);
  window.pull();
  EXPECT_FALSE(std::isnan(chart()->series(classes)->at(3.0)));
  window.actions()[ActionId::kUnpinPlots]->trigger();
  EXPECT_EQ(chart()->lines(), classes);
}

TEST_F(DayWorkTest, TheCameraHasAHistoryOfItsOwn) {
  const CameraView first = window.viewport().cameraView();
  EXPECT_FALSE(window.actions()[ActionId::kViewBack]->isEnabled());
  window.actions()[ActionId::kTop]->trigger();
  QTest::qWait(700);
  window.actions()[ActionId::kZoomIn]->trigger();
  window.actions()[ActionId::kZoomIn]->trigger();
  const CameraView last = window.viewport().cameraView();
  window.actions()[ActionId::kViewBack]->trigger();
  window.actions()[ActionId::kViewBack]->trigger();
  EXPECT_TRUE(window.viewport().cameraView() == first) << "zooming twice is one movement";
  EXPECT_FALSE(window.actions()[ActionId::kViewBack]->isEnabled());
  window.actions()[ActionId::kViewForward]->trigger();
  window.actions()[ActionId::kViewForward]->trigger();
  EXPECT_TRUE(window.viewport().cameraView() == last);
  EXPECT_FALSE(window.document().modified()) << "views are no edits";
}

TEST_F(DayWorkTest, TheCameraFollowsTheSelection) {
  const int ball = session.indexOf("ball");
  window.selection().setObjects({ball});
  window.actions()[ActionId::kFollowSelection]->setChecked(true);
  session.seek(0.5);
  window.pull();
  const Vector3d offset =
      window.viewport().cameraView().focus - window.moment().objects[static_cast<std::size_t>(ball)].p_WCom;
  for (const double t : {1.0, 2.3}) {
    session.seek(t);
    window.pull();
    const Vector3d now =
        window.viewport().cameraView().focus - window.moment().objects[static_cast<std::size_t>(ball)].p_WCom;
    EXPECT_NEAR((now - offset).norm(), 0.0, 1e-9);
  }
  window.actions()[ActionId::kFollowSelection]->setChecked(false);
  const CameraView still = window.viewport().cameraView();
  session.seek(3.0);
  window.pull();
  EXPECT_TRUE(window.viewport().cameraView() == still);
}

TEST_F(DayWorkTest, ArrowsAreAnEditAndOutliveTheFile) {
  const ModalAnswer answer("arrows", [](QWidget* dialog) {
    dialog->findChild<QDoubleSpinBox*>("least_force")->setValue(25.0);
    dialog->findChild<QCheckBox*>("automatic")->setChecked(false);
    dialog->findChild<QDoubleSpinBox*>("per_newton")->setValue(4.0);
    QMetaObject::invokeMethod(dialog, "accept");
  });
  window.actions()[ActionId::kArrowOptions]->trigger();
  ASSERT_TRUE(answer.answered());
  EXPECT_EQ(window.viewport().options().min_force, 25.0);
  EXPECT_FALSE(window.actions()[ActionId::kAutoScale]->isChecked());
  const std::string text = projectText(window.document().project(), "/tmp", {});
  const Project again = parseProject(text, "/tmp/a.abstand", "/tmp").project;
  EXPECT_TRUE(again.work.view == window.document().work().view);
  window.actions()[ActionId::kUndo]->trigger();
  EXPECT_EQ(window.viewport().options().min_force, ViewOptions().min_force);
}

TEST_F(DayWorkTest, SeparationHasARowForEachBodyPart) {
  bring("separation");
  SeparationPanel* panel = window.panels().separation;
  window.pull();
  EXPECT_EQ(panel->chart()->rows().size(), 14U);
  auto* reaction = panel->findChild<QDoubleSpinBox*>("reaction_time");
  const double before = panel->chart()->rows()[0].needed.person;
  reaction->setValue(0.5);
  EXPECT_NEAR(window.document().work().separation.options.reaction_time, 0.5, 1e-9);
  EXPECT_GT(panel->chart()->rows()[0].needed.person, before);
  const std::string text = projectText(window.document().project(), "/tmp", {});
  EXPECT_TRUE(parseProject(text, "/tmp/a.abstand", "/tmp").project.work.separation ==
              window.document().work().separation);
  QTest::mouseClick(panel->chart(), Qt::LeftButton, {}, QPoint(20, 22 + SeparationChart::kRowHeight / 2));
  EXPECT_EQ(window.selection().pair(), panel->chart()->rows()[0].pair);
  window.actions()[ActionId::kUndo]->trigger();
  EXPECT_NEAR(reaction->value(), 0.1, 1e-9);
}

/// A shell of two points, a root with two children, and a slice of three known cells.
BodyInside smallInside() {
  BodyInside inside;
  inside.points = {Vector3f::Zero(), Vector3f(0.1F, 0.0F, 0.0F)};
  inside.levels = {{{Vector3f::Zero(), 0.2F}},
                   {{Vector3f::Zero(), 0.1F}, {Vector3f(0.1F, 0.0F, 0.0F), 0.1F}}};
  inside.slice = {Vector3f(-0.1F, -0.1F, 0.0F), 0.1F, 2, 2, {-0.01F, 0.02F, 0.03F, std::nanf("")}};
  return inside;
}

TEST_F(DayWorkTest, TheInsideOfTheSelectionIsDrawn) {
  Viewport& view = window.viewport();
  std::vector<int> asked;
  view.setInsideSource([&](int object) {
    asked.push_back(object);
    return smallInside();
  });
  const int ball = session.indexOf("ball");
  window.selection().setObjects({ball});
  EXPECT_EQ(view.insideShown(), 0U);
  const QImage before = view.picture();
  for (const InsideView wanted : {InsideView::kPoints, InsideView::kTree, InsideView::kSlice}) {
    window.actions()[ActionId::kLookInside]->trigger();
    EXPECT_EQ(view.insideView(), wanted);
    EXPECT_EQ(view.insideShown(), 1U);
    EXPECT_NE(view.picture(), before);
  }
  EXPECT_EQ(asked, (std::vector<int>{ball, ball, ball}));
  window.actions()[ActionId::kLookInside]->trigger();
  EXPECT_EQ(view.insideShown(), 0U);
  window.actions()[ActionId::kTreeFiner]->trigger();
  EXPECT_EQ(view.insideView(), InsideView::kTree);
  window.selection().clear();
  EXPECT_EQ(view.insideShown(), 0U);
}

TEST_F(DayWorkTest, LayoutsAreMadeForATask) {
  const auto shown = [this](const char* name) { return !dock(name)->isHidden(); };
  window.actions()[ActionId::kLayoutReplay]->trigger();
  EXPECT_TRUE(shown("timeline") && shown("scene") && !shown("margins") && !shown("pairs"));
  window.actions()[ActionId::kLayoutTuning]->trigger();
  EXPECT_TRUE(shown("margins") && shown("curve") && !shown("notes"));
  window.actions()[ActionId::kLayoutReview]->trigger();
  EXPECT_TRUE(shown("events") && shown("notes") && !shown("margins"));
  window.actions()[ActionId::kResetLayout]->trigger();
  EXPECT_TRUE(shown("margins") && shown("pairs") && !shown("log"));
}

TEST_F(DayWorkTest, AnEmptyWindowOffersWhatCanBeOpened) {
  auto* page = window.findChild<StartPage*>();
  EXPECT_FALSE(page->isVisible());
  window.setSession(nullptr);
  ASSERT_TRUE(page->isVisible());
  const QSignalSpy scenes(&window, &MainWindow::openSceneRequested);
  page->findChild<QPushButton*>("start_demonstration")->click();
  ASSERT_EQ(scenes.size(), 1);
  EXPECT_TRUE(scenes[0][0].toString().endsWith("hug_boxing.yaml"));
  window.setSession(&session);
  EXPECT_FALSE(page->isVisible());
}

TEST_F(DayWorkTest, TheTourBringsEachPanelToTheFront) {
  window.actions()[ActionId::kTour]->trigger();
  auto* tour = window.findChild<Tour*>();
  ASSERT_TRUE(tour);
  EXPECT_FALSE(tour->back()->isEnabled());
  int steps = 1;
  while (tour->next()->text() == "&Next" && steps < 50) {
    tour->next()->click();
    ++steps;
  }
  EXPECT_EQ(tour->step(), steps - 1);
  EXPECT_GE(steps, 6);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !dock("notes")->visibleRegion().isEmpty(); }, kWaitMs));
  tour->next()->click();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !window.findChild<Tour*>(); }, kWaitMs));
}

}  // namespace day_work_test
}  // namespace abstand::ui
