// Margins of classes of pairs in the window on real sessions.
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QMessageBox>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include <nlohmann/json.hpp>

#include "core/base/text_file.hpp"
#include "tests/ui/slide_studio.hpp"
#include "ui/document/document.hpp"
#include "ui/document/project_file.hpp"
#include "ui/model/pair_class.hpp"
#include "ui/model/recording_review.hpp"
#include "ui/panels/class_margin_row.hpp"
#include "ui/panels/margin_curve.hpp"
#include "ui/panels/margin_panel.hpp"
#include "ui/panels/margin_row.hpp"
#include "ui/panels/margin_tools.hpp"
#include "ui/style/actions.hpp"

namespace abstand::studio {
namespace studio_classes_test {

using ui::ActionId;
using ui::PairClass;

constexpr double kSame = 1e-9;  // m: mm to m and back

/// A ball that drives at a person, and a table far below: pairs of three classes.
struct StudioClasses : SlideStudio {
  StudioClasses() : SlideStudio({.robot = 0.5, .person = 0.3, .stops_at = 1.8, .seconds = 4.0}) {
    const std::string text = readFile(scene, 1 << 20, true);
    scene = folder.write("cell.yaml", text +
                                          "objects: [{name: table, shape: {cuboid: {size: [0.5, 0.5, 0.1]}}, "
                                          "pose: {xyz: [0, 3, 0]}, margin: 0.01}]\n");
  }
  void SetUp() override {
    open();
    ASSERT_TRUE(analysed()) << window.review().problem().toStdString();
  }
  ui::ClassMarginRow* row(PairClass of) const { return window.panels().margins->classRow(of); }
  QAction* action(ActionId id) const { return window.actions()[id]; }
  const ui::Work& work() const { return window.document().work(); }
  double classMargin(const char* key) const {
    const auto found = work().classes.find(QString::fromLatin1(key));
    return found == work().classes.end() ? kNaN : found->metres;
  }
  bool judgedWith(double margin) {
    return QTest::qWaitFor([&] { return std::abs(window.review().marginOf(0, 0) - margin) < kSame; },
                           kLimitMs) &&
           QTest::qWaitFor(
               [&] {
                 QCoreApplication::processEvents();
                 return true;
               },
               100);
  }
  /// The session and its picture have this margin for all pairs of the class.
  bool shows(PairClass of, double margin) {
    return QTest::qWaitFor(
        [&] {
          window.pull();
          const view::SceneOutline& outline = *this->outline();
          int seen = 0;
          for (std::size_t p = 0; p < outline.pairs.size(); ++p) {
            if (ui::pairClassOf(outline, outline.pairs[p]) != of) continue;
            ++seen;
            if (std::abs(window.moment().pairs[p].margin - margin) > kSame) return false;
          }
          return seen > 0;
        },
        kLimitMs);
  }
  const view::SceneOutline* outline() {
    if (!outline_) outline_ = depth::openSession(scene_file::loadScene(scene), {})->outline();
    return &*outline_;
  }
  nlohmann::json tune(const std::string& options) {
    const auto out = folder.path() / "tune.json";
    const std::string command =
        "'" ABSTAND_PROGRAM "' tune '" + scene.string() + "' " + options + " --json >'" + out.string() + "'";
    EXPECT_EQ(std::system(command.c_str()), 0);
    return nlohmann::json::parse(readFile(out, 1 << 28, true));
  }
  void expectAs(const nlohmann::json& set) {
    const margin::MarginOutcome& outcome = window.review().review().outcome;
    EXPECT_EQ(outcome.stops, set["stops"].get<long>());
    EXPECT_EQ(outcome.false_stops, set["false_stops"].get<long>());
    EXPECT_EQ(outcome.missed_stops, set["missed_stops"].get<long>());
  }

 private:
  std::optional<view::SceneOutline> outline_;
};

TEST_F(StudioClasses, OnlyClassesOfTheSceneHaveRows) {
  EXPECT_TRUE(row(PairClass::kPersonRobot));
  EXPECT_TRUE(row(PairClass::kPersonThing));
  EXPECT_TRUE(row(PairClass::kRobotThing));
  EXPECT_FALSE(row(PairClass::kRobotRobot)) << "there is one link";
  EXPECT_FALSE(row(PairClass::kPersonThing)->row()->isEnabled()) << "not ticked";
  EXPECT_NEAR(row(PairClass::kPersonThing)->row()->metres(), 0.01, kSame) << "the largest sum is shown";
  window.panels().margin_tools->search()->setText("robot – thing");
  EXPECT_TRUE(row(PairClass::kRobotThing)->isVisible());
  EXPECT_FALSE(row(PairClass::kPersonRobot)->isVisible());
  EXPECT_FALSE(window.panels().margins->row(0)->isVisible());
  window.panels().margin_tools->search()->clear();
  EXPECT_TRUE(row(PairClass::kPersonRobot)->isVisible());
}

TEST_F(StudioClasses, ClassOfPeopleAndRobotsIsJudgedAsTune) {
  window.panels().margins->groupRow("person")->findChild<QSlider*>()->setValue(30);
  ASSERT_TRUE(judgedWith(0.03));
  ui::ClassMarginRow* people = row(PairClass::kPersonRobot);
  people->tick()->click();
  EXPECT_NEAR(classMargin("person_robot"), 0.03, kSame) << "no margin becomes smaller by the tick";
  const int steps = window.document().steps().count();
  auto* slider = people->findChild<QSlider*>();
  slider->setSliderDown(true);
  for (const int mm : {60, 90, 120}) slider->setValue(mm);
  slider->setSliderDown(false);
  EXPECT_EQ(window.document().steps().count(), steps + 1) << "a drag is one step";
  ASSERT_TRUE(judgedWith(0.12));
  ASSERT_TRUE(shows(PairClass::kPersonRobot, 0.12));
  EXPECT_TRUE(shows(PairClass::kRobotThing, 0.01)) << "other classes keep their sums";
  nlohmann::json expected;
  const nlohmann::json answer = tune("--margins 0.12");
  for (const auto& each : answer["margins"])
    if (each["part"] == "whole_body") expected = each;
  expectAs(expected);
  EXPECT_GT(window.review().review().outcome.stops, 0);
  // The same as a set of the command line.
  action(ActionId::kCopyMargins)->trigger();
  const std::string text = QApplication::clipboard()->text().toStdString();
  EXPECT_NE(text.find("classes:\n  person_robot: 0.12\n"), std::string::npos) << text;
  const auto file = folder.write("class.yaml", text);
  expectAs(tune("--margin-set '" + file.string() + "'")["margin_sets"].back());
  // And back.
  while (window.document().steps().canUndo()) window.document().steps().undo();
  EXPECT_TRUE(work().classes.isEmpty());
  EXPECT_FALSE(people->tick()->isChecked());
  ASSERT_TRUE(judgedWith(0.0));
  ASSERT_TRUE(shows(PairClass::kPersonRobot, 0.0));
  action(ActionId::kPasteMargins)->trigger();
  EXPECT_NEAR(classMargin("person_robot"), 0.12, kSame);
  EXPECT_NEAR(work().margins.value("person/head"), 0.03, kSame) << "the rows of the bodies come back, too";
  ASSERT_TRUE(judgedWith(0.12));
  expectAs(expected);
}

TEST_F(StudioClasses, TypedMarginOfThingsLeavesPeopleAndRobots) {
  const double before = window.review().marginOf(0, 0);
  row(PairClass::kRobotThing)->tick()->click();
  row(PairClass::kRobotThing)->findChild<QDoubleSpinBox*>()->setValue(250.0);
  ASSERT_TRUE(shows(PairClass::kRobotThing, 0.25));
  ASSERT_TRUE(shows(PairClass::kPersonRobot, before));
  EXPECT_EQ(window.review().marginOf(0, 0), before);
  // A body's own margin no longer counts for this class, and does for the others.
  window.panels().margins->groupRow("slide")->findChild<QSlider*>()->setValue(70);
  ASSERT_TRUE(shows(PairClass::kPersonRobot, before + 0.07));
  ASSERT_TRUE(shows(PairClass::kRobotThing, 0.25));
  row(PairClass::kRobotThing)->tick()->click();
  ASSERT_TRUE(shows(PairClass::kRobotThing, 0.08)) << "the sum again";
}

TEST_F(StudioClasses, PresetsLeaveLockedClassesAlone) {
  for (const PairClass of : {PairClass::kPersonRobot, PairClass::kRobotThing}) {
    row(of)->tick()->click();
    row(of)->findChild<QDoubleSpinBox*>()->setValue(200.0);
  }
  row(PairClass::kRobotThing)->findChild<QToolButton*>("lock")->click();
  EXPECT_TRUE(work().classes.value("robot_thing").locked);
  EXPECT_FALSE(row(PairClass::kRobotThing)->tick()->isEnabled());
  action(ActionId::kMargins50)->trigger();
  EXPECT_FALSE(work().classes.contains("person_robot")) << "the preset is for all pairs";
  EXPECT_NEAR(classMargin("robot_thing"), 0.2, kSame);
  ASSERT_TRUE(judgedWith(0.1));
  action(ActionId::kResetMargins)->trigger();
  EXPECT_NEAR(classMargin("robot_thing"), 0.2, kSame);
  QApplication::clipboard()->setText(
      "abstand_margins: 1\ndefault: {margin: 0.06}\nclasses: {robot_thing: 0.5, person_thing: 0.04}\n");
  action(ActionId::kPasteMargins)->trigger();
  EXPECT_NEAR(classMargin("robot_thing"), 0.2, kSame) << "locked";
  EXPECT_NEAR(classMargin("person_thing"), 0.04, kSame);
  ASSERT_TRUE(judgedWith(0.06));
  // Opened again, all is as it was saved.
  const ui::Work kept = work();
  const QString file = QString::fromStdString((folder.path() / "p.abstand").string());
  ui::writeProject(window.document().project(), file);
  window.document().setSaved(file);
  while (window.document().steps().canUndo()) window.document().steps().undo();
  ASSERT_TRUE(work().classes.isEmpty());
  window.document().setSaved(file);
  QSignalSpy ready(studio.get(), &Studio::ready);
  window.openFile(file);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !ready.isEmpty(); }, kLimitMs));
  EXPECT_EQ(work().classes, kept.classes);
  EXPECT_TRUE(row(PairClass::kRobotThing)->row()->locked());
  ASSERT_TRUE(shows(PairClass::kRobotThing, 0.2));
  ASSERT_TRUE(shows(PairClass::kPersonThing, 0.04));
}

TEST_F(StudioClasses, ComparedMarginsAreThoseOfTheClass) {
  row(PairClass::kPersonRobot)->tick()->click();
  row(PairClass::kPersonRobot)->findChild<QDoubleSpinBox*>()->setValue(300.0);
  ASSERT_TRUE(judgedWith(0.3));
  action(ActionId::kCompareMargins)->trigger();
  ASSERT_TRUE(work().compared);
  EXPECT_NEAR(work().compared->value("person/head"), 0.3, kSame);
  EXPECT_EQ(work().compared->value("ball"), 0.0) << "their sum is the margin of the class";
}

TEST_F(StudioClasses, CurveDragsTheClassInOneStep) {
  row(PairClass::kPersonRobot)->tick()->click();
  const ui::Work before = work();
  const int steps = window.document().steps().count();
  const int head = static_cast<int>(window.review().store()->layout().parts.front().object);
  for (const double metres : {0.05, 0.15, 0.2}) Q_EMIT window.panels().curve->dragged(head, metres);
  Q_EMIT window.panels().curve->released();
  EXPECT_EQ(window.document().steps().count(), steps + 1);
  EXPECT_EQ(classMargin("person_robot"), 0.2);
  EXPECT_EQ(work().margins, before.margins) << "the rows of the bodies stay";
  ASSERT_TRUE(judgedWith(0.2));
  ASSERT_TRUE(shows(PairClass::kPersonRobot, 0.2));
  action(ActionId::kUndo)->trigger();
  EXPECT_EQ(work(), before);
  // A locked class does not follow.
  row(PairClass::kPersonRobot)->findChild<QToolButton*>("lock")->click();
  Q_EMIT window.panels().curve->dragged(head, 0.25);
  Q_EMIT window.panels().curve->released();
  EXPECT_EQ(classMargin("person_robot"), before.classes.value("person_robot").metres);
}

TEST_F(StudioClasses, LockedClassOfPeopleAndRobotsTakesNoProposal) {
  row(PairClass::kPersonRobot)->tick()->click();
  row(PairClass::kPersonRobot)->findChild<QToolButton*>("lock")->click();
  action(ActionId::kProposeMargins)->trigger();
  const auto* box = window.findChild<QMessageBox*>();
  ASSERT_TRUE(box);
  EXPECT_TRUE(box->text().contains("locked")) << box->text().toStdString();
}

}  // namespace studio_classes_test
}  // namespace abstand::studio
