// What a killed program had is offered and recovered.
#include <QDir>
#include <QFile>
#include <QProcess>

#include "tests/ui/modal_answer.hpp"
#include "tests/ui/studio_window.hpp"
#include "ui/document/left_overs.hpp"
#include "ui/document/project_file.hpp"

namespace abstand::studio {
namespace recovery_test {

struct RecoveryTest : StudioWindow {
  RecoveryTest() {
    ui::Project project;
    project.work.scene = in("scene.yaml");
    project.work.margins["anna/torso"] = 0.25;
    project.viewpoint.camera = ui::CameraView{{0.1, 0.2, 0.9}, 3.5, 0.4, 0.3};
    ui::writeProject(project, in("p.abstand"));
  }
  QStringList autosaves() const { return QDir(kept()).entryList({"*.abstand"}, QDir::Files); }
  QString kept() const { return in("data/Abstand/abstand-studio/autosave"); }
  /// Runs the program on the project with another recording, and kills it when its work is on disk.
  void runAndKill() {
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("HOME", in("."));
    environment.insert("XDG_CONFIG_HOME", in("config"));
    environment.insert("XDG_DATA_HOME", in("data"));
    program.setProcessEnvironment(environment);
    program.setProcessChannelMode(QProcess::ForwardedChannels);
    program.start(ABSTAND_STUDIO, {in("p.abstand"), "--recording", in("turn.csv")});
    ASSERT_TRUE(program.waitForStarted(kLoadMs));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !autosaves().isEmpty(); }, kLoadMs));
    ASSERT_EQ(program.state(), QProcess::Running);
    program.kill();
    ASSERT_TRUE(program.waitForFinished(kLoadMs));
    ASSERT_EQ(program.exitStatus(), QProcess::CrashExit);
  }
};

TEST_F(RecoveryTest, OffersAndRecoversWorkOfKilledProcess) {
  runAndKill();
  if (HasFatalFailure()) return;
  ASSERT_EQ(autosaves().size(), 1);
  const QString left = autosaves().constFirst();
  EXPECT_EQ(QDir(kept()).entryList(QDir::Files | QDir::Hidden).size(), 2) << "the autosave and its lock";
  const auto recover = ui::ModalAnswer::click("recovery", "Recover");
  ASSERT_TRUE(opens([&] { window.keepAutosaves(kept()); })) << problem;
  EXPECT_TRUE(recover.answered());
  EXPECT_EQ(work().recording, in("turn.csv"));
  EXPECT_EQ(work().margins.value("anna/torso"), 0.25);
  EXPECT_EQ(window.viewport().cameraView(), (ui::CameraView{{0.1, 0.2, 0.9}, 3.5, 0.4, 0.3}));
  EXPECT_EQ(window.document().file(), in("p.abstand"));
  EXPECT_TRUE(window.document().modified());
  ASSERT_EQ(autosaves().size(), 1) << "that of this program";
  EXPECT_NE(autosaves().constFirst(), left);
  // A good end leaves nothing.
  const auto discard = ui::ModalAnswer::click("unsaved_changes", "Discard");
  EXPECT_TRUE(window.close());
  EXPECT_TRUE(autosaves().isEmpty());
}

TEST_F(RecoveryTest, PostponedWorkIsOfferedAgain) {
  runAndKill();
  if (HasFatalFailure()) return;
  {
    const auto later = ui::ModalAnswer::click("recovery", "Later");
    window.keepAutosaves(kept());
    EXPECT_TRUE(later.answered());
  }
  EXPECT_EQ(ui::leftOvers(kept()).size(), 1u);
  ui::MainWindow next;
  const auto forget = ui::ModalAnswer::click("recovery", "Delete");
  next.keepAutosaves(kept());
  EXPECT_TRUE(forget.answered());
  EXPECT_TRUE(autosaves().isEmpty());
}

TEST_F(RecoveryTest, AutosaveStaysUntilWorkIsOpen) {
  runAndKill();
  if (HasFatalFailure()) return;
  folder.write("scene.yaml", "abstand: 1\nhumans: broken\n");
  const auto recover = ui::ModalAnswer::click("recovery", "Recover");
  EXPECT_FALSE(opens([&] { window.keepAutosaves(kept()); }));
  EXPECT_EQ(autosaves().size(), 1);
}

}  // namespace recovery_test
}  // namespace abstand::studio
