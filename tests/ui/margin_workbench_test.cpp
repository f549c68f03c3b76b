// Search, locks, presets, sets of margins and proposals in the window.
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QTextBrowser>
#include <QToolButton>
#include <QUrl>

#include "core/base/text_file.hpp"
#include "tests/support/paths.hpp"
#include "tests/ui/fake_analysis.hpp"
#include "tests/ui/modal_answer.hpp"
#include "tests/ui/shown_window.hpp"
#include "ui/document/document.hpp"
#include "ui/document/project_file.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/recording_review.hpp"
#include "ui/model/selection.hpp"
#include "ui/panels/margin_panel.hpp"
#include "ui/panels/margin_row.hpp"
#include "ui/panels/margin_tools.hpp"
#include "ui/panels/proposal_dialog.hpp"
#include "ui/style/actions.hpp"

namespace abstand::ui {
namespace margin_workbench_test {

struct MarginWorkbench : ShownWindow {
  void SetUp() override {
    ShownWindow::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    hand = session.indexOf("operator/hand_left");
    head = session.indexOf("operator/head");
    link = session.indexOf("arm/link2");
    table = session.indexOf("table");
  }
  QAction* action(ActionId id) { return window.actions()[id]; }
  const Work& work() { return window.document().work(); }
  MarginPanel& panel() { return *window.panels().margins; }
  int steps() { return window.document().steps().count(); }
  double metres(int object) { return panel().row(object)->metres(); }
  void lock(int object) {
    auto* button = panel().row(object)->findChild<QToolButton*>("lock");
    button->click();
  }
  bool move(MarginRow* row, int object, int mm) {
    row->findChild<QSlider*>()->setValue(mm);
    return QTest::qWaitFor([&] { return std::abs(metres(object) - 1e-3 * mm) < 1e-9 && !moving(); }, kWaitMs);
  }
  bool moving() {
    QTest::qWait(2 * MarginPanel::kGatherMs);
    return false;
  }
  QString in(const char* name) const { return QString::fromStdString((folder.path() / name).string()); }
  bool problemSays(const QString& words) {
    for (auto* box : window.findChildren<QMessageBox*>())
      if (box->isVisible() && box->text().contains(words)) return true;
    return false;
  }

  testing::ScratchFolder folder;
  int hand{0}, head{0}, link{0}, table{0};
};

TEST_F(MarginWorkbench, OpensMarginsFile) {
  QSignalSpy scenes(&window, &MainWindow::openSceneRequested);
  folder.write("set.yaml",
               "# of the cell\nabstand_margins: 1\ncombine: sum\ndefault: {margin: 0}\n"
               "margins:\n  - {part: hand_left, margin: 0.111}\n");
  window.openFile(in("set.yaml"));
  EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(metres(hand) - 0.111) < 1e-9; }, kWaitMs));
  EXPECT_EQ(scenes.size(), 0);
  window.setSession(nullptr);
  window.openFile(in("set.yaml"));
  EXPECT_TRUE(problemSays("no scene"));
  folder.write("cell.yaml", "abstand: 1\n");
  window.openFile(in("cell.yaml"));
  EXPECT_EQ(scenes.size(), 1);
}

TEST_F(MarginWorkbench, SearchFiltersByPartLinkAndGroup) {
  auto* search = window.findChild<MarginTools*>()->search();
  search->setText("HAND");
  EXPECT_TRUE(panel().row(hand)->isVisibleTo(&panel()));
  EXPECT_FALSE(panel().row(head)->isVisibleTo(&panel()));
  EXPECT_TRUE(panel().groupRow("operator")->isVisibleTo(&panel()));
  EXPECT_FALSE(panel().groupRow("arm")->isVisibleTo(&panel()));
  // The row of a group moves what is shown.
  ASSERT_TRUE(move(panel().groupRow("operator"), hand, 90));
  EXPECT_NEAR(metres(head), 0.04, 1e-12);
  search->setText("arm");
  EXPECT_TRUE(panel().row(link)->isVisibleTo(&panel())) << "all of a group";
  EXPECT_TRUE(panel().row(session.indexOf("operator/forearm_left"))->isVisibleTo(&panel()));
  search->clear();
  EXPECT_TRUE(panel().row(head)->isVisibleTo(&panel()));
  action(ActionId::kFindMargin)->trigger();
  EXPECT_EQ(window.focusWidget(), search);
}

TEST_F(MarginWorkbench, LockedMarginStaysUnchanged) {
  lock(hand);
  EXPECT_TRUE(work().locked.contains("operator/hand_left"));
  EXPECT_EQ(steps(), 1);
  EXPECT_FALSE(panel().row(hand)->findChild<QSlider*>()->isEnabled());
  ASSERT_TRUE(move(panel().groupRow("operator"), head, 77));
  EXPECT_NEAR(metres(hand), 0.04, 1e-12) << "the row of the group";
  action(ActionId::kMargins100)->trigger();
  EXPECT_NEAR(metres(hand), 0.04, 1e-12) << "a preset";
  EXPECT_NEAR(metres(head), 0.1, 1e-12);
  QApplication::clipboard()->setText("abstand_margins: 1\ndefault: {margin: 0.2}\n");
  action(ActionId::kPasteMargins)->trigger();
  EXPECT_NEAR(metres(hand), 0.04, 1e-12) << "pasted";
  EXPECT_NEAR(metres(head), 0.2, 1e-12);
  action(ActionId::kResetMargins)->trigger();
  EXPECT_NEAR(metres(hand), 0.04, 1e-12);
  EXPECT_NEAR(metres(head), 0.04, 1e-12);
  while (action(ActionId::kUndo)->isEnabled()) action(ActionId::kUndo)->trigger();
  EXPECT_TRUE(work().locked.isEmpty());
  EXPECT_TRUE(panel().row(hand)->findChild<QSlider*>()->isEnabled());
}

TEST_F(MarginWorkbench, LockedMarginStaysWhenSceneIsReset) {
  ASSERT_TRUE(move(panel().row(hand), hand, 150));
  lock(hand);
  action(ActionId::kResetMargins)->trigger();
  EXPECT_NEAR(metres(hand), 0.15, 1e-9);
}

TEST_F(MarginWorkbench, GroupLocksAreOneStepAndSaved) {
  panel().groupRow("arm")->findChild<QToolButton*>("lock")->click();
  EXPECT_EQ(steps(), 1);
  EXPECT_EQ(work().locked.size(), 5);
  EXPECT_TRUE(panel().groupRow("arm")->locked());
  writeProject(window.document().project(), in("p.abstand"));
  EXPECT_EQ(readProject(in("p.abstand")).work.locked, work().locked);
  window.document().open(readProject(in("p.abstand")), in("p.abstand"), false);
  window.setSession(&session);
  EXPECT_TRUE(panel().row(link)->locked());
}

TEST_F(MarginWorkbench, PresetIsOneStep) {
  for (const auto& [id, margin] : {std::pair{ActionId::kNoMargins, 0.0},
                                   {ActionId::kMargins50, 0.05},
                                   {ActionId::kMargins100, 0.1},
                                   {ActionId::kMargins200, 0.2}}) {
    const int before = steps();
    action(id)->trigger();
    EXPECT_EQ(steps(), before + 1);
    for (const int object : {hand, head, link, table}) EXPECT_NEAR(metres(object), margin, 1e-12);
  }
  action(ActionId::kResetMargins)->trigger();
  EXPECT_NEAR(metres(link), 0.01, 1e-12);
  EXPECT_TRUE(work().margins.isEmpty());
  while (action(ActionId::kUndo)->isEnabled()) action(ActionId::kUndo)->trigger();
  EXPECT_NEAR(metres(hand), 0.04, 1e-12);
}

TEST_F(MarginWorkbench, CopyAndPasteRoundTrip) {
  ASSERT_TRUE(move(panel().row(hand), hand, 123));
  ASSERT_TRUE(move(panel().row(link), link, 31));
  const auto before = work().margins;
  action(ActionId::kCopyMargins)->trigger();
  const QString text = QApplication::clipboard()->text();
  EXPECT_TRUE(text.startsWith("abstand_margins: 1\ncombine: sum\n")) << text.toStdString();
  action(ActionId::kMargins200)->trigger();
  const int steps_before = steps();
  action(ActionId::kPasteMargins)->trigger();
  EXPECT_EQ(steps(), steps_before + 1);
  EXPECT_NEAR(metres(hand), 0.123, 1e-12);
  EXPECT_NEAR(metres(link), 0.031, 1e-12);
  EXPECT_NEAR(metres(head), 0.04, 1e-12);
  EXPECT_NEAR(metres(table), 0.2, 1e-12) << "things are in no set";
  action(ActionId::kCopyMargins)->trigger();
  EXPECT_EQ(QApplication::clipboard()->text(), text);
}

TEST_F(MarginWorkbench, SetIsSavedAndOpened) {
  ASSERT_TRUE(move(panel().row(hand), hand, 123));
  {
    const auto name = ModalAnswer::choose("save_margins", in("m"));
    action(ActionId::kSaveMargins)->trigger();
    EXPECT_TRUE(name.answered());
  }
  EXPECT_NE(readFile(folder.path() / "m.yaml").find("hand_left, margin: 0.123"), std::string::npos);
  action(ActionId::kNoMargins)->trigger();
  const auto name = ModalAnswer::choose("open_margins", in("m.yaml"));
  action(ActionId::kOpenMargins)->trigger();
  EXPECT_TRUE(name.answered());
  EXPECT_NEAR(metres(hand), 0.123, 1e-12);
  EXPECT_NEAR(metres(link), 0.01, 1e-12);
}

TEST_F(MarginWorkbench, CommandLineSetsBecomeRowsIfPossible) {
  QStringList links;
  for (int i = 0; i < 5; ++i)
    links << QString("  - {link: arm/link%1, margin: %2}").arg(i).arg(0.1 + 0.01 * i);
  QApplication::clipboard()->setText("abstand_margins: 1\nmargins:\n" + links.join('\n') + '\n');
  action(ActionId::kPasteMargins)->trigger();
  EXPECT_NEAR(metres(link), 0.12, 1e-12);
  EXPECT_NEAR(metres(hand), 0.0, 1e-12) << "one margin a link is that of the links";
  QApplication::clipboard()->setText(
      "abstand_margins: 1\ndefault: {margin: 0.1}\nmargins: [{part: head, margin: 0.3}]\n");
  action(ActionId::kPasteMargins)->trigger();
  EXPECT_NEAR(metres(head), 0.3, 1e-12);
  EXPECT_NEAR(metres(hand), 0.1, 1e-12);
  EXPECT_NEAR(metres(link), 0.0, 1e-12);
}

TEST_F(MarginWorkbench, RejectsSetsThatRowsCannotShow) {
  const std::pair<const char*, const char*> cases[] = {
      {"abstand_margins: 1\ndefault: {margin: 0.1}\nmargins: [{part: head, link: arm/link1, margin: 0.3}]\n",
       "adds these two"},
      {"abstand_margins: 1\ndefault: {margin: 0.1, robot_time: 0.2}\n", "grows with speeds"},
      {"abstand_margins: 1\nmargins: [{part: head, margin: 0.3}]\n", "found no margin for"},
      {"abstand_margins: 1\ndefault: {margin: 0.1}\nmargins: [{link: other/link1, margin: 0.3}]\n",
       "expected one of the scene"},
      {"hello", "clipboard:1:1"}};
  for (const auto& [text, words] : cases) {
    SCOPED_TRACE(text);
    QApplication::clipboard()->setText(text);
    action(ActionId::kPasteMargins)->trigger();
    EXPECT_TRUE(problemSays(words));
    EXPECT_EQ(steps(), 0);
  }
}

/// With an analysis, whose clearances are in closed form.
struct MarginProposals : MarginWorkbench {
  void SetUp() override {
    MarginWorkbench::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    session.recording = &analysis;
    session.setMargin(head, 0.04);  // so that there is a snapshot again
    window.setSession(&session);
  }
  void TearDown() override { window.setSession(nullptr); }
  FakeAnalysis analysis{session.outline(), [](std::size_t part, std::size_t frame) {
                          return valley(part, 0.02 * static_cast<double>(frame)) - 0.2;
                        }};
};

TEST_F(MarginProposals, NeedCompleteAnalysis) {
  analysis.run(200);
  window.review().pull();
  action(ActionId::kProposeMargins)->trigger();
  EXPECT_TRUE(problemSays("Nothing is proposed yet"));
  EXPECT_FALSE(window.findChild<ProposalDialog*>());
}

TEST_F(MarginProposals, ApplyToUnlockedRowsInOneStepAndMissNoStop) {
  analysis.runAll();
  window.review().pull();
  action(ActionId::kNoMargins)->trigger();
  ASSERT_TRUE(QTest::qWaitFor([&] { return window.review().review().outcome.missed_stops > 0; }, kWaitMs));
  lock(head);
  const int before = steps();
  action(ActionId::kProposeMargins)->trigger();
  auto* dialog = window.findChild<ProposalDialog*>();
  ASSERT_TRUE(dialog);
  const QString text = dialog->sentences()->toPlainText();
  EXPECT_TRUE(text.contains("hand_left: ")) << text.toStdString();
  EXPECT_TRUE(text.contains("Decided at ")) << text.toStdString();
  EXPECT_TRUE(text.contains("too small")) << text.toStdString();
  // A click goes to the moment and the pair.
  Q_EMIT dialog->sentences()->anchorClicked(QUrl("0"));
  const double t = margin::proposeMargins(*window.review().store(), {})[0].decided_by->t;
  EXPECT_NEAR(window.playback().time(), t, 1e-9);
  EXPECT_GE(window.selection().pair(), 0);
  dialog->accept();
  EXPECT_EQ(steps(), before + 1);
  EXPECT_EQ(metres(head), 0.0) << "locked";
  EXPECT_GT(metres(hand), 0.0);
  EXPECT_EQ(metres(link), 0.0) << "rows of links stay";
  lock(head);
  action(ActionId::kProposeMargins)->trigger();
  window.findChild<ProposalDialog*>("proposal")->accept();
  ASSERT_TRUE(QTest::qWaitFor([&] { return window.review().review().outcome.missed_stops == 0; }, kWaitMs));
}

}  // namespace margin_workbench_test
}  // namespace abstand::ui
