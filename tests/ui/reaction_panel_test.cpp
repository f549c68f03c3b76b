// The panel of laws: fields, refusals, undo, project file, back to the scene file.
#include "ui/panels/reaction_panel.hpp"

#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <QUndoStack>
#include <QWheelEvent>
#include <algorithm>

#include "tests/ui/shown_window.hpp"
#include "ui/dock_set.hpp"
#include "ui/document/document.hpp"
#include "ui/document/project_file.hpp"
#include "ui/panels/law_row.hpp"

namespace abstand::ui {
namespace reaction_panel_test {

struct ReactionPanelTest : ShownWindow {
  void SetUp() override {
    ShownWindow::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    panel = window.panels().reactions;
    session.log.clear();
  }
  LawRow* row(const std::string& key) const {
    const auto& rows = panel->rows();
    const auto at = std::find_if(rows.begin(), rows.end(), [&](LawRow* r) { return r->key() == key; });
    return at == rows.end() ? nullptr : *at;
  }
  void type(const std::string& key, const char* text) {
    QLineEdit* field = row(key)->field();
    field->selectAll();
    QTest::keyClicks(field, QString::fromUtf8(text));
    QTest::keyClick(field, Qt::Key_Return);
  }
  QCheckBox* law(const char* name) const {
    return panel->findChild<QCheckBox*>(QStringLiteral("law ") + QLatin1String(name));
  }
  QString head() const { return panel->findChild<QLabel*>("reaction_head")->text(); }
  const Work& work() const { return window.document().work(); }
  QUndoStack& steps() { return window.document().steps(); }

  ReactionPanel* panel{nullptr};
};

TEST_F(ReactionPanelTest, TypedGainReachesSessionAndIsUndone) {
  EXPECT_EQ(head(), "As in the scene file");
  EXPECT_TRUE(session.reactions.empty()) << "nothing is sent as long as nothing differs";
  EXPECT_EQ(row("torque.gain")->field()->text(), "1");
  type("torque.gain", "2.5");
  ASSERT_EQ(session.reactions.size(), 1u);
  EXPECT_EQ(session.reactions[0].torque->gain, 2.5);
  EXPECT_EQ(work().reactions["arm"].numbers.at("torque.gain"), config::JointNumbers{2.5});
  EXPECT_EQ(head(), "1 difference from the scene file");
  EXPECT_TRUE(window.document().modified());
  EXPECT_EQ(steps().undoText(), "laws of arm: Gain");
  steps().undo();
  EXPECT_EQ(session.reactions.back().torque->gain, 1.0);
  EXPECT_EQ(row("torque.gain")->field()->text(), "1");
  EXPECT_TRUE(work().reactions.isEmpty());
  steps().redo();
  EXPECT_EQ(session.reactions.back().torque->gain, 2.5);
  // The scene's number typed is no difference.
  type("torque.gain", "1");
  EXPECT_TRUE(work().reactions.isEmpty());
}

TEST_F(ReactionPanelTest, ChosenResponseReachesSessionAndIsUndone) {
  auto* box = panel->findChild<QComboBox*>("response lost_person");
  ASSERT_NE(box, nullptr);
  EXPECT_EQ(box->currentText(), "protective stop");
  const auto sent = [this] {
    return session.reactions.back().stop.policy.of(safety::StopReason::kLostPerson);
  };
  box->setFocus();
  QTest::keyClick(box, Qt::Key_Down);
  EXPECT_EQ(box->currentText(), "emergency stop");
  ASSERT_EQ(session.reactions.size(), 1u);
  EXPECT_EQ(sent(), safety::StopResponse::kEmergency);
  EXPECT_EQ(head(), "1 difference from the scene file");
  EXPECT_EQ(steps().undoText(), "laws of arm: lost person: emergency stop");
  QWheelEvent notch(box->rect().center(), box->mapToGlobal(box->rect().center()), {}, {0, 120}, Qt::NoButton,
                    Qt::NoModifier, Qt::NoScrollPhase, false);
  QApplication::sendEvent(box, &notch);
  EXPECT_EQ(box->currentText(), "emergency stop") << "the wheel scrolls the panel";
  steps().undo();
  EXPECT_EQ(sent(), safety::StopResponse::kProtective);
  EXPECT_EQ(box->currentText(), "protective stop");
  steps().redo();
  QTest::mouseClick(panel->findChild<QToolButton*>("back response lost_person"), Qt::LeftButton);
  EXPECT_EQ(sent(), safety::StopResponse::kProtective);
  EXPECT_TRUE(work().reactions.isEmpty());
}

TEST_F(ReactionPanelTest, BadNumbersAreRefusedWithSentence) {
  const int before = steps().index();
  const std::pair<const char*, const char*> cases[] = {{"-1", "Expected a number from 0 to 1000000."},
                                                       {"x", "Expected a number from 0 to 1000000."},
                                                       {"1; 2", "Expected a number from 0 to 1000000."}};
  for (const auto& [text, sentence] : cases) {
    type("torque.gain", text);
    EXPECT_EQ(row("torque.gain")->refusal(), sentence) << text;
  }
  EXPECT_EQ(steps().index(), before);
  EXPECT_TRUE(session.reactions.empty());
  type("torque.gain", "3");
  EXPECT_EQ(row("torque.gain")->refusal(), "");
  EXPECT_EQ(steps().index(), before + 1);
  // A rule between two numbers.
  law("repulsion")->click();
  type("repulsion.stop_distance", "0.2");
  EXPECT_TRUE(row("repulsion.stop_distance")->refusal().contains("expected less than the range"));
  EXPECT_EQ(work().reactions["arm"].numbers.count("repulsion.stop_distance"), 0u);
  QTest::keyClick(row("repulsion.stop_distance")->field(), Qt::Key_Escape);
  EXPECT_EQ(row("repulsion.stop_distance")->field()->text(), "0");
  EXPECT_EQ(row("repulsion.stop_distance")->refusal(), "");
}

TEST_F(ReactionPanelTest, ListsOfJointsAndNoLimitAreTyped) {
  const int joints = session.outline().robots[0].joints;
  QStringList numbers;
  for (int i = 0; i < joints; ++i) numbers << QString::number(10 + i);
  type("torque.limit", numbers.join("; ").toUtf8().constData());
  ASSERT_FALSE(session.reactions.empty());
  EXPECT_EQ(session.reactions.back().torque->limit.size(), static_cast<std::size_t>(joints));
  EXPECT_EQ(session.reactions.back().torque->limit.back(), 9.0 + joints);
  type("stop.resume_after", "1.5");
  EXPECT_EQ(session.reactions.back().stop.resume_after, 1.5);
  type("stop.resume_after", "inf");
  EXPECT_EQ(session.reactions.back().stop.resume_after, kInfinity);
}

TEST_F(ReactionPanelTest, LawsAreSwitched) {
  law("torque")->click();
  EXPECT_FALSE(session.reactions.back().torque);
  EXPECT_FALSE(row("torque.gain")->isVisibleTo(panel)) << "its numbers have no effect";
  EXPECT_EQ(steps().undoText(), "laws of arm: Torque off");
  law("speed")->click();
  EXPECT_TRUE(session.reactions.back().speed);
  EXPECT_EQ(head(), "2 differences from the scene file");
  EXPECT_TRUE(law("admittance")->isEnabled());
  EXPECT_TRUE(law("admittance")->toolTip().contains("anew on their planned motion"));
  law("admittance")->click();
  EXPECT_TRUE(session.reactions.back().admittance);
  law("admittance")->click();
  EXPECT_FALSE(session.reactions.back().admittance);
  panel->findChild<QPushButton*>("reaction_back")->click();
  EXPECT_TRUE(work().reactions.isEmpty());
  EXPECT_TRUE(session.reactions.back().torque);
  EXPECT_FALSE(session.reactions.back().speed);
  EXPECT_EQ(head(), "As in the scene file");
  steps().undo();
  EXPECT_TRUE(session.reactions.back().speed);
}

TEST_F(ReactionPanelTest, ArrowKeysAreOneUndoStepAndBackButtonAnother) {
  const int before = steps().index();
  QLineEdit* field = row("torque.gain")->field();
  for (int i = 0; i < 5; ++i) QTest::keyClick(field, Qt::Key_Up);
  EXPECT_NEAR(session.reactions.back().torque->gain, 1.5, 1e-12);
  EXPECT_EQ(session.reactions.size(), 5u) << "each press is heard at once";
  EXPECT_EQ(steps().index(), before + 1);
  auto* back = panel->findChild<QToolButton*>("back torque.gain");
  ASSERT_TRUE(back);
  EXPECT_TRUE(back->isVisibleTo(panel));
  back->click();
  EXPECT_EQ(session.reactions.back().torque->gain, 1.0);
  EXPECT_EQ(steps().index(), before + 2);
  EXPECT_FALSE(back->isVisibleTo(panel));
  steps().undo();
  EXPECT_NEAR(session.reactions.back().torque->gain, 1.5, 1e-12);
  steps().undo();
  EXPECT_TRUE(work().reactions.isEmpty());
}

TEST_F(ReactionPanelTest, EveryFieldTellsUnitMeaningAndSceneKey) {
  ASSERT_GT(panel->rows().size(), 35u);
  for (const LawRow* each : panel->rows()) {
    const QString tip = each->field()->toolTip();
    EXPECT_GE(tip.count(QLatin1Char('\n')), 3) << each->key();
    EXPECT_TRUE(tip.contains(QString::fromStdString(each->key()))) << each->key();
    EXPECT_FALSE(each->field()->accessibleName().isEmpty()) << each->key();
  }
}

TEST_F(ReactionPanelTest, ProjectKeepsLawsAndSessionHearsThemWhenOpened) {
  type("torque.gain", "2.5");
  law("repulsion")->click();
  type("repulsion.force", "80");
  const std::string text = projectText(window.document().project(), "/cell");
  const Project read = parseProject(text, "p.abstand", "/cell").project;
  EXPECT_EQ(projectText(read, "/cell"), text);
  window.document().open(Project(), QString(), false);
  window.setSession(&session);
  EXPECT_EQ(row("torque.gain")->field()->text(), "1");
  session.reactions.clear();
  window.document().open(read, QString(), false);
  window.setSession(&session);
  ASSERT_EQ(session.reactions.size(), 1u);
  EXPECT_EQ(session.reactions[0].torque->gain, 2.5);
  EXPECT_EQ(session.reactions[0].repulsion->force, 80.0);
  EXPECT_EQ(row("repulsion.force")->field()->text(), "80");
  EXPECT_EQ(head(), "3 differences from the scene file");
}

}  // namespace reaction_panel_test
}  // namespace abstand::ui
