// Walks through docs/tutorial-window.md, step by step, in a real window; takes its pictures where
// ABSTAND_TUTORIAL_PICTURES names a folder.
#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QFileInfo>
#include <QImage>
#include <QLineEdit>
#include <QRegularExpression>
#include <QScrollBar>
#include <fstream>
#include <sstream>

#include "tests/ui/modal_answer.hpp"
#include "tests/ui/studio_window.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/recording_review.hpp"
#include "ui/model/selection.hpp"
#include "ui/panels/lane_view.hpp"
#include "ui/panels/proposal_dialog.hpp"
#include "ui/panels/timeline_panel.hpp"
#include "ui/report_commands.hpp"
#include "ui/style/actions.hpp"
#include "ui/window_grab.hpp"

namespace abstand::studio {
namespace tutorial_test {

using ui::ActionId;

constexpr int kStepMs = 240000;  // no step takes so long, on a busy machine either
constexpr int kSettleMs = 700;   // until everything is drawn

QString page() {
  std::ifstream in(testing::projectFile("docs/tutorial-window.md"));
  std::stringstream text;
  text << in.rdbuf();
  return QString::fromStdString(text.str()).replace(QRegularExpression("\\s+"), " ");
}

struct Tutorial : StudioWindow {
  Tutorial() { window.resize(1280, 800); }
  /// The page names this command with its first key.
  void trigger(ActionId id) {
    const QAction* action = window.actions()[id];
    // "Undo: what it takes back".
    const QString name = QString(action->text()).remove('&').section(':', 0, 0);
    EXPECT_TRUE(page().contains("*" + name + "*")) << name.toStdString();
    EXPECT_TRUE(action->isEnabled()) << name.toStdString();
    window.actions()[id]->trigger();
  }
  void picture(const char* name) {
    EXPECT_TRUE(page().contains(QString("(pictures/%1.png)").arg(name))) << name;
    QTest::qWait(kSettleMs);
    const QByteArray into = qgetenv("ABSTAND_TUTORIAL_PICTURES");
    if (into.isEmpty()) return;
    QWidget* shown = QApplication::activeModalWidget();
    const QImage image = shown ? shown->grab().toImage() : ui::grabWindow(window);
    EXPECT_TRUE(image.save(QString::fromLocal8Bit(into) + "/" + name + ".png"));
  }
  void walk();
  /// A click into the lane of a part.
  void clickLane(int part, double t) {
    ui::LaneView& lanes = *window.panels().timeline->laneView();
    ASSERT_TRUE(lanes.isVisible());
    lanes.verticalScrollBar()->setValue(part * ui::LaneView::kLaneHeight);
    for (int y = 0; y < lanes.viewport()->height(); ++y)
      if (lanes.laneAt(y) == part)
        return QTest::mouseClick(lanes.viewport(), Qt::LeftButton, {}, {lanes.xOf(t), y + 1});
    FAIL() << "the lane of part " << part << " cannot be seen";
  }
  const margin::MarginOutcome& outcome() const { return window.review().review().outcome; }
  template <class Condition>
  bool waitFor(Condition condition) {
    return QTest::qWaitFor(condition, kStepMs);
  }
};

/// In windows of other sizes, without pictures.
struct TutorialAt : Tutorial, ::testing::WithParamInterface<std::pair<int, int>> {
  TutorialAt() {
    qunsetenv("ABSTAND_TUTORIAL_PICTURES");
    window.resize(GetParam().first, GetParam().second);
    window.actions()[ActionId::kResetLayout]->trigger();
  }
};

void Tutorial::walk() {
  qputenv("PATH", QFileInfo(ABSTAND_PROGRAM).absolutePath().toLocal8Bit() + ":" + qgetenv("PATH"));
  // 1. Open.
  const QString scene = QString::fromStdString(testing::projectFile("data/scenes/hug_reach.yaml").string());
  ASSERT_TRUE(page().contains("data/scenes/hug_reach.yaml"));
  const QSignalSpy ready(&studio, &Studio::ready);
  {
    const ui::ModalAnswer answer = ui::ModalAnswer::choose("open_files", scene);
    trigger(ActionId::kOpenScene);
    ASSERT_TRUE(answer.answered());
  }
  ASSERT_TRUE(waitFor([&] { return !ready.isEmpty(); }));
  ASSERT_TRUE(waitFor([&] { return window.review().state() == view::AnalysisNews::State::kDone; }))
      << window.review().problem().toStdString();
  picture("tutorial_open");

  // 2. Replay.
  const double start = window.playback().time();
  trigger(ActionId::kPlay);
  ASSERT_TRUE(waitFor([&] { return window.playback().time() > start + 0.2; }));
  window.actions()[ActionId::kPlay]->trigger();  // "Pause" now
  ASSERT_TRUE(waitFor([&] { return !window.playback().playing(); }));
  for (const ActionId id : {ActionId::kStepForward, ActionId::kStepBack}) trigger(id);
  trigger(ActionId::kNextContact);
  ASSERT_FALSE(window.review().review().events.empty());
  ASSERT_TRUE(waitFor([&] {
    const auto& events = window.review().review().events;
    return std::any_of(events.begin(), events.end(), [&](const auto& event) {
      return std::abs(window.playback().time() - event.t0) < 0.02 ||
             std::abs(window.playback().time() - event.t_nearest) < 0.02;
    });
  }));
  picture("tutorial_replay");

  // 3. Understand.
  const margin::ReviewEvent first = window.review().review().events.front();
  clickLane(static_cast<int>(first.part), first.t_nearest);
  EXPECT_GE(window.selection().pair(), 0);
  EXPECT_EQ(window.selection().pair(), window.review().pairOf(first.part, first.link));
  auto* inspector = window.findChild<QDockWidget*>("inspector");
  ASSERT_TRUE(inspector);
  inspector->show();
  inspector->raise();
  picture("tutorial_understand");
  {
    const ui::ModalAnswer answer("what_if_settings",
                                 [](QWidget* dialog) { static_cast<QDialog*>(dialog)->reject(); });
    trigger(ActionId::kWhatIf);
    EXPECT_TRUE(answer.answered());
  }

  // 4. Tune.
  trigger(ActionId::kMargins50);
  ASSERT_TRUE(waitFor([&] { return std::abs(window.review().marginOf(0, 0) - 0.1) < 1e-9; }));
  QCoreApplication::processEvents();
  trigger(ActionId::kCompareMargins);
  trigger(ActionId::kProposeMargins);
  auto* proposal = window.findChild<ui::ProposalDialog*>();
  ASSERT_TRUE(proposal);
  proposal->accept();
  QTest::qWait(kSettleMs);
  EXPECT_EQ(outcome().missed_stops, 0) << "what was proposed misses no stop";
  picture("tutorial_tune");

  // 5. Report.
  const QString file = in("report.html");
  {
    const ui::ModalAnswer answer("report", [&](QWidget* dialog) {
      picture("tutorial_report");
      dialog->findChild<QLineEdit*>()->setText(file);
      static_cast<QDialog*>(dialog)->accept();
    });
    trigger(ActionId::kReport);
    EXPECT_TRUE(answer.answered());
  }
  ASSERT_TRUE(waitFor([&] { return !window.reports().waiting(); }));
  EXPECT_TRUE(QFileInfo::exists(file));
  // Back to the beginning.
  while (window.document().steps().canUndo()) trigger(ActionId::kUndo);
  EXPECT_TRUE(work().margins.isEmpty());
}

TEST_F(Tutorial, FromOpeningToReport) { walk(); }

TEST_P(TutorialAt, FromOpeningToReport) {
  const QSize size = window.size();
  EXPECT_EQ(size, QSize(GetParam().first, GetParam().second));
  walk();
  EXPECT_EQ(window.size(), size) << "no step makes it larger";
}

INSTANTIATE_TEST_SUITE_P(Sizes, TutorialAt, ::testing::Values(std::pair(1024, 700), std::pair(3840, 2160)));

TEST_F(Tutorial, KeysOfThePageAreThoseOfTheWindow) {
  // "*Name* (Key)", with the name of a command as the menus have it.
  auto found = QRegularExpression("\\*([^*()]+)\\* \\(([^)]+)\\)").globalMatch(page());
  int commands = 0;
  while (found.hasNext()) {
    const auto match = found.next();
    bool known = false;
    for (const auto& entry : window.actions().all()) {
      if (QString(entry.action->text()).remove('&') != match.captured(1)) continue;
      known = true;
      QString key = match.captured(2);
      key.replace("→", "Right").replace("←", "Left");
      const QString own = entry.action->shortcut().toString(QKeySequence::PortableText);
      EXPECT_EQ(own.toStdString(), key.toStdString()) << match.captured(1).toStdString();
    }
    EXPECT_TRUE(known) << match.captured(1).toStdString();
    ++commands;
  }
  EXPECT_GE(commands, 10);
}

TEST_F(Tutorial, PicturesAreThere) {
  auto found = QRegularExpression("\\((pictures/[a-z_]+\\.png)\\)").globalMatch(page());
  int pictures = 0;
  for (; found.hasNext(); ++pictures) {
    const auto name = found.next().captured(1).toStdString();
    EXPECT_TRUE(exists(testing::projectFile("docs/" + name))) << name;
  }
  EXPECT_EQ(pictures, 5);
}

}  // namespace tutorial_test
}  // namespace abstand::studio
