// Recordings to choose from, files that change while they are shown, and layouts of projects.
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QMessageBox>
#include <QStatusBar>

#include "core/base/output_file.hpp"
#include "core/base/text_file.hpp"
#include "tests/ui/studio_window.hpp"
#include "ui/document/project_file.hpp"
#include "ui/file_commands.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/selection.hpp"
#include "ui/panels/margin_panel.hpp"
#include "ui/panels/margin_row.hpp"
#include "ui/panels/recording_panel.hpp"
#include "ui/style/actions.hpp"

namespace abstand::studio {
namespace studio_reload_test {

using ui::ActionId;

struct StudioReload : StudioWindow {
  StudioReload() {
    writeUpright("walk.csv", 0.0);
    writeUpright("turn.csv", 0.3);
    window.resize(1400, 900);
  }
  bool opensAll(std::initializer_list<const char*> names) {
    QStringList files;
    for (const char* name : names) files << in(name);
    return opens([&] { window.files().open(files); });
  }
  QComboBox* choice() const { return window.panels().recordings->choice(); }
  QDockWidget* dock(const char* name) const {
    return window.findChild<QDockWidget*>(QString::fromLatin1(name));
  }
  QAction* action(ActionId id) const { return window.actions()[id]; }
  double torsoX() {
    window.pull();
    return window.moment().objects[0].X_WB.translation().x();
  }
  void makeWork() {
    window.document().edit("work", [](ui::Work& work) { work.margins["anna/torso"] = 0.25; });
    action(ActionId::kTop)->trigger();
    camera = window.viewport().cameraView();
    window.selection().setObjects({3});
  }
  void expectWork() {
    EXPECT_EQ(work().margins.value("anna/torso"), 0.25);
    EXPECT_EQ(window.panels().margins->row(0)->metres(), 0.25);
    EXPECT_EQ(window.viewport().cameraView(), camera);
    EXPECT_EQ(window.selection().objects(), std::vector<int>{3});
  }
  void write(const char* name, const std::string& text) { writeFile(folder.path() / name, text); }
  bool says(const char* words) {
    return QTest::qWaitFor(
        [&] { return window.statusBar()->currentMessage().contains(QLatin1String(words)); }, kLoadMs);
  }
  ui::CameraView camera;
};

TEST_F(StudioReload, SeveralRecordingsAreChosenFromAList) {
  ASSERT_TRUE(opensAll({"scene.yaml", "walk.csv", "turn.csv"})) << problem;
  EXPECT_FALSE(window.findChild<QMessageBox*>());
  EXPECT_EQ(work().recording, in("walk.csv")) << "the first is shown";
  ASSERT_EQ(choice()->count(), 2);
  EXPECT_EQ(choice()->currentText(), "walk.csv");
  EXPECT_TRUE(choice()->isVisibleTo(window.panels().recordings));
  EXPECT_NEAR(torsoX(), 0.0, 1e-6);
  makeWork();
  ASSERT_TRUE(opens([&] {
    choice()->setCurrentIndex(1);
    Q_EMIT choice()->activated(1);
  })) << problem;
  EXPECT_EQ(work().recording, in("turn.csv"));
  EXPECT_NEAR(torsoX(), 0.3, 1e-6);
  expectWork();
  ASSERT_TRUE(opens([&] { action(ActionId::kUndo)->trigger(); })) << problem;
  EXPECT_EQ(choice()->currentText(), "walk.csv");
  EXPECT_NEAR(torsoX(), 0.0, 1e-6);
  expectWork();
  // One that is opened later joins them.
  writeUpright("late.csv", 0.6);
  ASSERT_TRUE(opensAll({"late.csv"})) << problem;
  EXPECT_EQ(choice()->count(), 3);
  EXPECT_EQ(choice()->currentText(), "late.csv");
  ui::writeProject(window.document().project(), in("p.abstand"));
  window.document().setSaved(in("p.abstand"));
  Q_EMIT window.closeRequested();
  EXPECT_EQ(choice()->count(), 0);
  ASSERT_TRUE(opensAll({"p.abstand"})) << problem;
  EXPECT_EQ(work().recordings, QStringList({in("walk.csv"), in("turn.csv"), in("late.csv")}));
  EXPECT_EQ(choice()->currentText(), "late.csv");
}

TEST_F(StudioReload, UnreadableRecordingOfSeveralGivesWayToTheNext) {
  folder.write("bad.csv", "t,foo\n0,1\n");
  const QSignalSpy left_out(&studio, &Studio::leftOut);
  ASSERT_TRUE(opensAll({"bad.csv", "turn.csv", "walk.csv"})) << problem;
  EXPECT_EQ(work().recording, in("turn.csv"));
  EXPECT_EQ(choice()->count(), 2);
  ASSERT_EQ(left_out.size(), 1);
  EXPECT_EQ(left_out[0][0].toStringList().size(), 1);
}

TEST_F(StudioReload, EditedSceneIsShownAndWorkStays) {
  ASSERT_TRUE(opensAll({"scene.yaml"})) << problem;
  makeWork();
  window.playback().seek(0.7);
  ASSERT_TRUE(QTest::qWaitFor([&] { return std::abs(window.playback().time() - 0.7) < 0.05; }, kLoadMs));
  dock("events")->raise();
  std::string text = readFile(folder.path() / "scene.yaml", 1 << 20);
  text.replace(text.find("[-1, 0, 1]"), 10, "[-2, 0, 1]");
  ASSERT_TRUE(opens([&] { write("scene.yaml", text); })) << problem;
  window.pull();
  EXPECT_NEAR(window.moment().objects[14].X_WB.translation().x(), -2.0, 1e-9);
  expectWork();
  EXPECT_NEAR(window.playback().time(), 0.7, 0.06);
  EXPECT_TRUE(window.document().steps().canUndo()) << "the steps stay, too";
  EXPECT_TRUE(says("scene.yaml has changed and was read again"));
  // So does its recording.
  ASSERT_TRUE(opens([&] { writeUpright("walk.csv", 0.45); })) << problem;
  window.playback().seek(0.0);
  EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(torsoX() - 0.45) < 1e-6; }, kLoadMs));
  expectWork();
}

TEST_F(StudioReload, BrokenEditLeavesWhatIsShown) {
  ASSERT_TRUE(opensAll({"scene.yaml"})) << problem;
  makeWork();
  const std::string good = readFile(folder.path() / "scene.yaml", 1 << 20);
  write("scene.yaml", "abstand: 1\nhumanz: []\n");
  ASSERT_TRUE(says("cannot be read; what is shown stays")) << "with the reason";
  EXPECT_TRUE(window.statusBar()->currentMessage().contains("scene.yaml:2:1"))
      << window.statusBar()->currentMessage().toStdString();
  EXPECT_FALSE(window.findChild<QMessageBox*>()) << "nothing stands in the way";
  expectWork();
  EXPECT_TRUE(window.panels().margins->row(14));
  // An editor that replaces the file.
  folder.write("new.yaml", good + "# again\n");
  ASSERT_TRUE(opens([&] {
    std::filesystem::rename(folder.path() / "new.yaml", folder.path() / "scene.yaml");
  })) << problem;
  expectWork();
  // And one that takes it away first.
  std::filesystem::remove(folder.path() / "scene.yaml");
  QTest::qWait(3 * FileWatch::kSettleMs);
  ASSERT_TRUE(opens([&] { write("scene.yaml", good + "# and again\n"); })) << problem;
  expectWork();
}

TEST_F(StudioReload, UnchangedFileIsNotReadAgain) {
  ASSERT_TRUE(opensAll({"scene.yaml"})) << problem;
  const QSignalSpy ready(&studio, &Studio::ready);
  std::filesystem::permissions(folder.path() / "scene.yaml", std::filesystem::perms::owner_exec,
                               std::filesystem::perm_options::add);
  QTest::qWait(4 * FileWatch::kSettleMs);
  EXPECT_TRUE(ready.isEmpty());
}

TEST_F(StudioReload, LayoutOfPanelsIsPartOfTheProject) {
  ASSERT_TRUE(opensAll({"scene.yaml"})) << problem;
  const QSize size = window.size();
  dock("plots")->hide();
  dock("log")->show();
  window.addDockWidget(Qt::LeftDockWidgetArea, dock("inspector"));
  QTest::qWait(50);
  window.document().setSaved(in("p.abstand"));
  action(ActionId::kSave)->trigger();
  EXPECT_FALSE(window.document().viewpoint().layout.isEmpty());
  const std::string first = readFile(folder.path() / "p.abstand", 1 << 20);
  action(ActionId::kResetLayout)->trigger();
  EXPECT_TRUE(dock("plots")->isVisible());
  EXPECT_NE(window.dockWidgetArea(dock("inspector")), Qt::LeftDockWidgetArea);
  ASSERT_TRUE(opensAll({"p.abstand"})) << problem;
  EXPECT_FALSE(dock("plots")->isVisible());
  EXPECT_FALSE(dock("log")->isHidden());
  EXPECT_EQ(window.dockWidgetArea(dock("inspector")), Qt::LeftDockWidgetArea);
  EXPECT_EQ(window.size(), size);
  EXPECT_FALSE(window.document().modified());
  QTest::qWait(50);
  action(ActionId::kSave)->trigger();
  EXPECT_EQ(readFile(folder.path() / "p.abstand", 1 << 20), first) << "the same bytes";
  // A damaged layout, or one of another version of the window, changes nothing.
  ui::Project project = ui::readProject(in("p.abstand"));
  project.viewpoint.layout = "nonsense";
  ui::writeProject(project, in("q.abstand"));
  action(ActionId::kResetLayout)->trigger();
  ASSERT_TRUE(opensAll({"q.abstand"})) << problem;
  EXPECT_TRUE(dock("plots")->isVisible());
}

}  // namespace studio_reload_test
}  // namespace abstand::studio
