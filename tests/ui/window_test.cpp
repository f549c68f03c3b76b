// The window as a whole, driven as a user does.
#include "ui/main_window.hpp"

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QSlider>
#include <QStatusBar>
#include <QTableView>
#include <QTest>
#include <QTreeWidget>

#include "tests/support/paths.hpp"
#include "tests/ui/fake_session.hpp"
#include "ui/file_commands.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/recent_files.hpp"
#include "ui/model/stop_text.hpp"
#include "ui/panels/group_panel.hpp"
#include "ui/panels/margin_panel.hpp"
#include "ui/panels/margin_row.hpp"
#include "ui/panels/note_panel.hpp"
#include "ui/panels/pair_panel.hpp"
#include "ui/panels/robot_panel.hpp"
#include "ui/panels/status_panel.hpp"
#include "ui/panels/time_strip.hpp"
#include "ui/panels/timeline_panel.hpp"
#include "ui/project_commands.hpp"
#include "ui/style/actions.hpp"

namespace abstand::ui {
namespace window_test {

constexpr int kWaitMs = 5000;
constexpr double kExact = 1e-9;  // s; a frame is 0.02 s

struct WindowTest : ::testing::Test {
  void SetUp() override {
    QSettings().clear();
    window.resize(1200, 800);
    window.setSession(&session);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, kWaitMs));
    session.log.clear();
  }
  void key(int k, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    // Shortcuts belong to the active window, and without a window manager nobody makes one active.
    QApplication::setActiveWindow(&window);
    QTest::keyClick(&window, static_cast<Qt::Key>(k), modifiers);
    window.pull();
  }
  void drop(const QStringList& paths) {
    QMimeData data;
    QList<QUrl> urls;
    for (const QString& path : paths) urls << QUrl::fromLocalFile(path);
    data.setUrls(urls);
    QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &enter);
    accepted = enter.isAccepted();
    if (!accepted) return;
    QDropEvent event(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &event);
    QApplication::processEvents();
  }
  FakeSession session;
  MainWindow window;
  bool accepted{false};
};

TEST_F(WindowTest, KeysMoveTheClockExactly) {
  const double frame = session.outline().frame_period;
  key(Qt::Key_Right);
  key(Qt::Key_Right);
  EXPECT_NEAR(session.time(), 2 * frame, kExact);
  key(Qt::Key_Left);
  EXPECT_NEAR(session.time(), frame, kExact);
  key(Qt::Key_Right, Qt::ShiftModifier);
  key(Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_NEAR(session.time(), 2.0 + frame, kExact);
  key(Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_NEAR(session.time(), 1.0 + frame, kExact);
  key(Qt::Key_End);
  EXPECT_EQ(session.time(), session.outline().end);
  key(Qt::Key_Right);
  EXPECT_EQ(session.time(), session.outline().end);
  key(Qt::Key_Home);
  EXPECT_EQ(session.time(), session.outline().start);
  EXPECT_EQ(window.playback().time(), session.time());
}

TEST_F(WindowTest, SpacePlaysAndPauses) {
  key(Qt::Key_Space);
  EXPECT_TRUE(session.playing());
  session.advance(0.1);
  window.pull();
  EXPECT_NEAR(window.playback().time(), session.time(), kExact);
  key(Qt::Key_Space);
  EXPECT_FALSE(session.playing());
}

TEST_F(WindowTest, FocusedTextFieldReceivesKeys) {
  QLineEdit* box = window.panels().pairs->filterBox();
  QApplication::setActiveWindow(&window);
  box->setFocus();
  ASSERT_TRUE(box->hasFocus());
  QTest::keyClicks(box, "c v");
  EXPECT_EQ(box->text(), "c v");
  EXPECT_TRUE(session.log.empty());
}

TEST_F(WindowTest, StripFollowsPointer) {
  TimeStrip* strip = window.panels().timeline->strip();
  const int y = strip->height() / 2;
  QTest::mousePress(strip, Qt::LeftButton, {}, QPoint(strip->xOf(3.0), y));
  EXPECT_NEAR(session.time(), strip->timeAt(strip->xOf(3.0)), kExact);
  QMouseEvent move(QEvent::MouseMove, QPoint(strip->xOf(7.0), y), Qt::NoButton, Qt::LeftButton,
                   Qt::NoModifier);
  QApplication::sendEvent(strip, &move);
  EXPECT_NEAR(session.time(), strip->timeAt(strip->xOf(7.0)), kExact);
  EXPECT_EQ(window.playback().time(), session.time());
}

TEST_F(WindowTest, MarginReachesSession) {
  const int hand = session.indexOf("operator/hand_left");
  window.panels().margins->row(hand)->findChild<QSlider*>()->setValue(123);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !session.log.empty(); }, kWaitMs));
  EXPECT_EQ(session.log, std::vector<std::string>{"margin " + std::to_string(hand) + " 0.123"});
}

TEST_F(WindowTest, DroppedFilesOpenByType) {
  const testing::ScratchFolder folder;
  const auto made = [&](const char* name) {
    return QString::fromStdString(folder.write(name, "abstand: 1\n").string());
  };
  const QSignalSpy scenes(&window, &MainWindow::openSceneRequested);
  const QSignalSpy batches(&window.files(), &FileCommands::batchWanted);
  drop({made("walk.bvh"), made("cell.yaml"), made("table.stl")});
  EXPECT_TRUE(accepted);
  ASSERT_EQ(batches.size(), 1) << "together";
  const auto batch = batches[0][0].value<FileBatch>();
  EXPECT_EQ(batch.scene, made("cell.yaml"));
  EXPECT_EQ(batch.recording, made("walk.bvh"));
  EXPECT_EQ(batch.added, QStringList{made("table.stl")});
  EXPECT_TRUE(batch.fresh);
  drop({made("cell.yaml")});
  ASSERT_EQ(scenes.size(), 1);
  EXPECT_EQ(scenes[0][0].toString(), made("cell.yaml"));
  const QSignalSpy projects(&window.projects(), &ProjectCommands::failed);
  drop({"/somewhere/work.abstand"});
  EXPECT_TRUE(accepted);
  ASSERT_EQ(projects.size(), 1) << "it was asked for, and is not there";
  EXPECT_TRUE(projects[0][1].toString().contains("work.abstand"));
  drop({"/somewhere/picture.gif"});
  EXPECT_FALSE(accepted);
  EXPECT_EQ(scenes.size(), 1);
}

TEST_F(WindowTest, RecentScenesAreNewestFirst) {
  for (int i = 0; i < kRecentFiles + 2; ++i) rememberFile(QStringLiteral("/scenes/%1.yaml").arg(i));
  rememberFile("/scenes/4.yaml");
  EXPECT_EQ(recentFiles(), (QStringList{"/scenes/4.yaml", "/scenes/6.yaml", "/scenes/5.yaml",
                                        "/scenes/3.yaml", "/scenes/2.yaml"}));
}

TEST_F(WindowTest, LayoutAndViewPersist) {
  auto* plots = window.findChild<QDockWidget*>("plots");
  plots->hide();
  window.actions()[ActionId::kVelocities]->setChecked(true);
  window.actions()[ActionId::kFloor]->setChecked(false);
  window.close();
  MainWindow next;
  next.show();
  EXPECT_FALSE(next.findChild<QDockWidget*>("plots")->isVisible());
  EXPECT_TRUE(next.findChild<QDockWidget*>("pairs")->isVisible());
  EXPECT_TRUE(next.actions()[ActionId::kVelocities]->isChecked());
  EXPECT_FALSE(next.actions()[ActionId::kFloor]->isChecked());
  next.actions()[ActionId::kResetLayout]->trigger();
  EXPECT_TRUE(next.findChild<QDockWidget*>("plots")->isVisible());
}

TEST_F(WindowTest, StatusBarShowsCulledPairs) {
  const auto* label = window.findChild<QLabel*>("left_out");
  ASSERT_TRUE(label);
  const QString pairs = QString::number(session.outline().pairs.size());
  const auto shows = [&](const QString& text) {
    window.pull();
    return QTest::qWaitFor([&] { return label->text() == text; }, kWaitMs);
  };
  session.setWork({.checked = 12, .rested = 34, .beyond = 5, .deferred = 6, .longest_wait = 7});
  EXPECT_TRUE(shows("Checked 12 of " + pairs + ", skipped 39 (far away), postponed 6"))
      << label->text().toStdString();
  EXPECT_TRUE(label->isVisible());
  for (const char* part : {"checked: 12\n", "clearance: 34\n", "horizon: 5\n", "6 (longest: 7 cycles)"})
    EXPECT_TRUE(label->toolTip().contains(part)) << part << " in " << label->toolTip().toStdString();
  const int still = static_cast<int>(session.outline().pairs.size()) - 12 - 34 - 5 - 6;
  EXPECT_TRUE(label->toolTip().contains(": " + QString::number(still) + "\n"));
  // Nothing left out, nothing said of it.
  session.setWork({.checked = 3});
  EXPECT_TRUE(shows("Checked 3 of " + pairs)) << label->text().toStdString();
  window.setSession(nullptr);
  EXPECT_TRUE(label->text().isEmpty());
}

TEST_F(WindowTest, RobotPanelShowsStateAndCause) {
  auto* panel = window.panels().robots;
  const auto* head = panel->findChild<QLabel*>("robots_head");
  const auto* state = panel->findChild<QLabel*>("state arm");
  const auto* reason = panel->findChild<QLabel*>("reason arm");
  const auto* bar = window.findChild<QLabel*>("robots");
  auto* reset = panel->findChild<QPushButton*>("reset_stops");
  ASSERT_TRUE(head && state && reason && bar && reset);
  const auto shows = [&](const QLabel* label, const QString& text) {
    window.pull();
    return QTest::qWaitFor([&] { return label->text() == text; }, kWaitMs);
  };
  EXPECT_TRUE(shows(head, "Restarted on their planned motion at 0.000 s; reacting since then"));
  EXPECT_TRUE(shows(state, "arm: running since 0.000 s, speed 100 %"));
  EXPECT_TRUE(reason->text().isEmpty());
  EXPECT_EQ(bar->text(), "Robots: running");
  EXPECT_TRUE(bar->isVisible());
  EXPECT_FALSE(reset->isEnabled());

  safety::StopCause cause{safety::StopReason::kDistance, 0.0398, 0.04, 0, -1};
  const auto [a, b] = session.outline().pairs[0];
  const QString pair =
      QString::fromStdString(session.outline().objects[static_cast<std::size_t>(a)].name + " – " +
                             session.outline().objects[static_cast<std::size_t>(b)].name);
  session.setRobot([&](view::SceneSnapshot&, view::RobotSnapshot& robot) {
    robot.state = safety::StopState::kProtectiveStop;
    robot.cause = cause;
    robot.since = 6.574;
    robot.speed_scale = 0.0;
    robot.log.add({6.574, safety::StopState::kRunning, safety::StopState::kProtectiveStop, cause, 6.574});
  });
  EXPECT_TRUE(shows(state, "⚠ arm: protective stop since 6.574 s, speed 0 %")) << state->text().toStdString();
  EXPECT_EQ(reason->text(), "distance 39.8 mm, limit 40.0 mm, " + pair);
  EXPECT_EQ(bar->text(), "⚠ arm: protective stop");
  EXPECT_EQ(panel->log()->toPlainText(),
            "6.574 s  arm: running → protective stop: distance 39.8 mm, limit 40.0 mm, " + pair);

  // One line more for each change, and none twice.
  session.setRobot([&](view::SceneSnapshot&, view::RobotSnapshot& robot) {
    robot.state = safety::StopState::kWaitingForReset;
    robot.since = 7.0;
    robot.log.add(
        {7.0, safety::StopState::kProtectiveStop, safety::StopState::kWaitingForReset, cause, 0.426});
  });
  EXPECT_TRUE(shows(bar, "⚠ arm: waiting for reset"));
  EXPECT_EQ(panel->log()->blockCount(), 2);
  ASSERT_TRUE(reset->isEnabled());
  session.log.clear();
  reset->click();
  EXPECT_EQ(session.log, std::vector<std::string>{"reset stops"});
  session.setRobot([&](view::SceneSnapshot&, view::RobotSnapshot& robot) {
    robot.refused_resets = 1;
    robot.refusal = safety::ResetRefusal::kCause;
  });
  EXPECT_TRUE(QTest::qWaitFor([&] { return panel->log()->blockCount() == 3; }, kWaitMs));
  EXPECT_TRUE(panel->log()->toPlainText().endsWith("arm: reset refused: a cause asks for a stop"));

  // A new beginning: nothing is behind them.
  session.setRobot([&](view::SceneSnapshot& snapshot, view::RobotSnapshot& robot) {
    robot = {};
    snapshot.loop_start = 3.2;
    ++snapshot.loops;
  });
  EXPECT_TRUE(shows(head, "Restarted on their planned motion at 3.200 s; reacting since then"));
  EXPECT_TRUE(panel->log()->toPlainText().isEmpty());
  EXPECT_TRUE(window.statusBar()->currentMessage().contains("3.200 s"));

  window.setSession(nullptr);
  EXPECT_FALSE(panel->findChild<QLabel*>("state arm"));
}

TEST_F(WindowTest, RobotLogListsEachBrokenLimitOnce) {
  const auto* log = window.panels().robots->log();
  const auto lines = [&](int count) {
    window.pull();
    return QTest::qWaitFor([&] { return log->toPlainText().count("beyond its") == count; }, kWaitMs);
  };
  const std::string joint = session.outline().joints.at(1).name;
  const bool slides = session.outline().joints.at(1).prismatic;
  session.setRobot([](view::SceneSnapshot&, view::RobotSnapshot& robot) {
    robot.breach_count = 1;
    robot.breaches[0] = {1, mechanism::LimitKind::kVelocity, -2.1, -1.92, 6.574, 6.5, 3};
  });
  EXPECT_TRUE(lines(1));
  EXPECT_EQ(log->toPlainText().toStdString(),
            "6.574 s  arm: joint " + joint + " beyond its velocity limit: " +
                (slides ? "-2.10 m/s, limit -1.92 m/s" : "-2.10 rad/s, limit -1.92 rad/s"));
  // Worse is no news, another limit is.
  session.setRobot([](view::SceneSnapshot&, view::RobotSnapshot& robot) {
    robot.breach_count = 2;
    robot.breaches[0].value = -2.5;
    robot.breaches[1] = {1, mechanism::LimitKind::kEffort, 31.0, 30.0, 7.0, 7.0, 1};
  });
  EXPECT_TRUE(lines(2));
  session.setRobot([](view::SceneSnapshot& snapshot, view::RobotSnapshot& robot) {
    robot = {};
    ++snapshot.loops;
  });
  EXPECT_TRUE(lines(0));
}

TEST_F(WindowTest, ListsReservationsOfScene) {
  NotePanel& panel = *window.panels().notes;
  const auto title = [&] { return window.findChild<QDockWidget*>("notes")->windowTitle(); };
  EXPECT_EQ(panel.topLevelItemCount(), 0);
  EXPECT_EQ(title(), "Reservations");
  FakeSession doubtful;
  doubtful.scene_notes = {
      {"missing_body", "1 of 2 links of arm have no body: tool", scene::Severity::kAlways},
      {"units_guess", "a.bvh: the units are guessed (cm)", scene::Severity::kStrict},
      {"remark", "a.bvh: read as cm, y up", scene::Severity::kNote}};
  window.setSession(&doubtful);
  ASSERT_EQ(panel.topLevelItemCount(), 3);
  EXPECT_EQ(title(), "⚠ Reservations (2)");
  const auto row = [&](int i) {
    const QTreeWidgetItem* item = panel.topLevelItem(i);
    return item->text(0) + "|" + item->text(1) + "|" + item->text(2);
  };
  EXPECT_EQ(row(0), "⚠ fails check|missing_body|1 of 2 links of arm have no body: tool");
  EXPECT_EQ(row(1), "⚠ fails check --strict|units_guess|a.bvh: the units are guessed (cm)");
  EXPECT_EQ(row(2), "to know|remark|a.bvh: read as cm, y up");
  window.setSession(nullptr);
  EXPECT_EQ(panel.topLevelItemCount(), 0);
  EXPECT_EQ(title(), "Reservations");
}

TEST_F(WindowTest, ReactToggleOutlivesSession) {
  QAction* react = window.actions()[ActionId::kReact];
  EXPECT_TRUE(react->isEnabled());
  EXPECT_TRUE(react->isChecked());
  key(Qt::Key_R);
  EXPECT_EQ(session.log, std::vector<std::string>{"react off"});
  const auto* bar = window.findChild<QLabel*>("robots");
  EXPECT_TRUE(QTest::qWaitFor([&] { return bar->text() == "React: off"; }, kWaitMs));
  FakeSession next;
  window.setSession(&next);
  EXPECT_EQ(next.log, std::vector<std::string>{"react off"});
  next.log.clear();
  key(Qt::Key_R);
  EXPECT_EQ(next.log, std::vector<std::string>{"react on"});
  next.log.clear();
  key(Qt::Key_R, Qt::ShiftModifier);
  EXPECT_EQ(next.log, std::vector<std::string>{"reset stops"});
  window.setSession(nullptr);
  EXPECT_FALSE(react->isEnabled());
}

TEST_F(WindowTest, PairGroupsRunPauseAndStop) {
  auto& panel = *window.panels().groups;
  auto* tree = panel.tree();
  const auto* head = panel.findChild<QLabel*>("groups_head");
  ASSERT_TRUE(QTest::qWaitFor([&] { return tree->topLevelItemCount() == 2; }, kWaitMs));
  const int pairs = static_cast<int>(session.outline().pairs.size());
  EXPECT_EQ(head->text(), QString("All %1 pairs are checked.").arg(pairs));
  const int with_people = tree->topLevelItem(0)->childCount();
  tree->topLevelItem(0)->setSelected(true);
  panel.findChild<QPushButton*>("groups_pause")->click();
  EXPECT_EQ(session.log, std::vector<std::string>{"pause 0"});
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        return head->text() == QString("⚠ %1 of %2 pairs are not checked: their distances are stale.")
                                   .arg(with_people)
                                   .arg(pairs);
      },
      kWaitMs));
  EXPECT_EQ(tree->topLevelItem(0)->text(2), "paused: stale");
  const auto* left_out = window.findChild<QLabel*>("left_out");
  EXPECT_TRUE(left_out->text().startsWith(QString("⚠ %1 pairs not checked.").arg(with_people)));
  // In the table such a pair shows no distance, and sorts as the nearest.
  const auto* table = window.panels().pairs->table()->model();
  EXPECT_EQ(table->index(0, PairTableModel::kState).data().toString(), "? not checked");
  EXPECT_EQ(table->index(0, PairTableModel::kDistance).data().toString(), "–");
  session.log.clear();
  panel.findChild<QPushButton*>("groups_run")->click();
  EXPECT_EQ(session.log, std::vector<std::string>{"run 0"});
  EXPECT_TRUE(QTest::qWaitFor([&] { return head->text().startsWith("All"); }, kWaitMs));
}

TEST_F(WindowTest, PairMovesBetweenGroups) {
  auto& panel = *window.panels().groups;
  auto* tree = panel.tree();
  ASSERT_TRUE(QTest::qWaitFor([&] { return tree->topLevelItemCount() == 2; }, kWaitMs));
  tree->topLevelItem(1)->child(0)->setSelected(true);
  auto* add = panel.findChild<QPushButton*>("groups_add");
  EXPECT_FALSE(add->isEnabled()) << "it is in a group";
  const int pair = tree->topLevelItem(1)->child(0)->data(0, Qt::UserRole + 1).toInt();
  panel.findChild<QPushButton*>("groups_remove")->click();
  EXPECT_EQ(session.log, std::vector<std::string>{"remove " + std::to_string(pair)});
  ASSERT_TRUE(QTest::qWaitFor([&] { return tree->topLevelItemCount() == 3; }, kWaitMs));
  EXPECT_EQ(tree->topLevelItem(0)->text(0), "In no group");
  EXPECT_EQ(tree->topLevelItem(0)->text(2), "removed: stale");
  ASSERT_TRUE(add->isEnabled()) << "the pair stays selected";
  session.log.clear();
  add->menu()->actions()[0]->trigger();
  EXPECT_EQ(session.log, std::vector<std::string>{"add 0 " + std::to_string(pair)});
  EXPECT_TRUE(QTest::qWaitFor([&] { return tree->topLevelItemCount() == 2; }, kWaitMs));
}

TEST_F(WindowTest, ReactionTorquesToggle) {
  QAction* torques = window.actions()[ActionId::kReactionTorques];
  EXPECT_TRUE(torques->isEnabled() && torques->isChecked());
  torques->trigger();
  EXPECT_EQ(session.log, std::vector<std::string>{"torques off"});
  FakeSession next;
  window.setSession(&next);
  EXPECT_EQ(next.log, std::vector<std::string>{"torques off"});
}

TEST_F(WindowTest, PlotsJointTorques) {
  auto* joint = window.findChild<QComboBox*>("torque_joint");
  ASSERT_TRUE(joint);
  EXPECT_EQ(joint->count(), 1 + static_cast<int>(session.outline().joints.size()));
  EXPECT_EQ(joint->currentText(), "largest of all");
  joint->setCurrentIndex(2);
  Q_EMIT joint->activated(2);
  session.play(true);
  session.advance(0.2);
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        for (const QLabel* label : window.findChildren<QLabel*>())
          if (label->text().contains("reaction&nbsp;-4.0")) return true;
        return false;
      },
      kWaitMs));
}

TEST_F(WindowTest, ShowsWhyNothingReacts) {
  RobotPanel panel;
  view::SceneOutline outline;
  outline.reacting = {"arm"};
  outline.cannot_react = "s.yaml:3:5: error: found no mass";
  panel.open(outline);
  panel.refresh(outline, {});
  EXPECT_EQ(panel.findChild<QLabel*>("robots_head")->text(),
            "Not reacting: s.yaml:3:5: error: found no mass");
}

TEST_F(WindowTest, CausesHaveUnits) {
  const view::SceneOutline& outline = session.outline();
  const auto text = [&](const safety::StopCause& cause) {
    return causeText(cause, outline, 0).toStdString();
  };
  EXPECT_EQ(text({safety::StopReason::kSeparation, 0.5, 0.25, -1, -1}),
            "separation 0.50 m/s, limit 0.25 m/s");
  EXPECT_EQ(text({safety::StopReason::kEnergy, 0.1234, 0.0, -1, -1}), "energy 0.123 J, limit 0.000 J");
  EXPECT_EQ(text({safety::StopReason::kLostPerson, kInfinity, 0.2, -1, -1}),
            "lost person – s, limit 0.200 s");
  EXPECT_EQ(text({safety::StopReason::kTorque, kNaN, 40.0, -1, 2}), "torque, limit 40.0 N·m, joint joint3");
  EXPECT_EQ(text({safety::StopReason::kJointSpeed, 2.5, 2.0, -1, 99}),
            "joint speed 2.50 rad/s, limit 2.00 rad/s");
  EXPECT_EQ(text({safety::StopReason::kUser}), "user");
  EXPECT_EQ(text({safety::StopReason::kBraking, 0.0123, 0.05, -1, -1}),
            "braking path 12.3 mm, limit 50.0 mm");
}

TEST_F(WindowTest, ShowsOpeningProgress) {
  const auto* text = window.findChild<QLabel*>("opening");
  const auto* bar = window.findChild<QProgressBar*>();
  ASSERT_TRUE(text && bar);
  EXPECT_FALSE(bar->isVisible());
  window.showOpening({});
  EXPECT_TRUE(bar->isVisible());
  EXPECT_EQ(bar->maximum(), 0);  // busy, no share known
  EXPECT_EQ(text->text(), "Reading files");
  window.showOpening({.begun = 3, .all = 16, .name = "link3", .building = false, .fraction = 0.25});
  EXPECT_EQ(text->text(), "Structure 3 of 16: link3");
  EXPECT_EQ(4 * bar->value(), bar->maximum());
  window.showOpening({.begun = 4, .all = 16, .name = "link4", .building = true, .fraction = 0.5});
  EXPECT_EQ(text->text(), "Building structure 4 of 16: link4");
  EXPECT_EQ(2 * bar->value(), bar->maximum());
  window.hideOpening();
  EXPECT_FALSE(bar->isVisible());
  EXPECT_FALSE(text->isVisible());
}

TEST_F(WindowTest, SessionMayBeReplaced) {
  window.setSession(nullptr);
  window.pull();
  key(Qt::Key_Right);
  EXPECT_TRUE(session.log.empty());
  FakeSession other;
  window.setSession(&other);
  key(Qt::Key_Right);
  EXPECT_NEAR(other.time(), other.outline().frame_period, kExact);
  window.setSession(nullptr);
}

}  // namespace window_test
}  // namespace abstand::ui
