// The import dialog: what is wished is read, and what was read is shown.
#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFile>
#include <QLabel>
#include <QPushButton>

#include "app/studio/import_reader.hpp"
#include "tests/ui/modal_answer.hpp"
#include "tests/ui/studio_window.hpp"
#include "ui/document/project_file.hpp"
#include "ui/import_commands.hpp"
#include "ui/panels/ghost_view.hpp"
#include "ui/panels/import_dialog.hpp"

namespace abstand::studio {
namespace import_test {

/// A recording in centimetres with y up whose joints have names that no map knows.
std::string unknownRecording() {
  return "HIERARCHY\nROOT Q1\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation "
         "Yrotation\n"
         "JOINT Q2\n{\nOFFSET 0 50 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n"
         "JOINT Q3\n{\nOFFSET 0 15 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nEnd Site\n{\nOFFSET 0 15 "
         "0\n}\n}\n"
         "JOINT Q4\n{\nOFFSET 20 -5 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n"
         "JOINT Q5\n{\nOFFSET 0 -30 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nEnd Site\n{\nOFFSET 0 -25 "
         "0\n}\n}\n}\n}\n}\n"
         "MOTION\nFrames: 3\nFrame Time: 0.1\n"
         "0 100 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n1 100 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n"
         "2 100 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n";
}

int rowOf(const ui::ImportFound& found, const char* joint) { return found.canonical.indexOf(joint); }

struct ImportTest : StudioWindow {
  ImportTest() { folder.write("unknown.bvh", unknownRecording()); }
};

TEST_F(ImportTest, TheReaderTakesJointsUnitsAndAxis) {
  ui::ImportFound first = readForImport(in("unknown.bvh"), {});
  ASSERT_EQ(first.problem, QString());
  ui::ImportWish wish{"cm", "y", "", {}};
  for (int i = 0; i < first.canonical.size(); ++i) wish.joints << QString();
  wish.joints[rowOf(first, "pelvis")] = "Q1";
  wish.joints[rowOf(first, "neck")] = "Q2";
  wish.joints[rowOf(first, "shoulder_left")] = "Q4";
  wish.joints[rowOf(first, "elbow_left")] = "Q5";
  const ui::ImportFound found = readForImport(in("unknown.bvh"), wish);
  ASSERT_EQ(found.problem, QString());
  EXPECT_EQ(found.used[rowOf(found, "elbow_left")], "Q5");
  ASSERT_EQ(found.frames.size(), 3U);
  const Vector3d neck = found.frames[0].joints[static_cast<std::size_t>(rowOf(found, "neck"))];
  EXPECT_NEAR(neck.z(), 1.5, 1e-6) << "100 cm + 50 cm, y up";
  wish.units = "m";
  EXPECT_NEAR(readForImport(in("unknown.bvh"), wish)
                  .frames[0]
                  .joints[static_cast<std::size_t>(rowOf(found, "neck"))]
                  .z(),
              150.0, 1e-3);
  EXPECT_FALSE(readForImport(in("none.bvh"), {}).problem.isEmpty());
  EXPECT_FALSE(readForImport(folder.path().string().c_str(), {}).problem.isEmpty());
}

TEST_F(ImportTest, AChosenJointMovesTheGhost) {
  ui::ImportDialog dialog(in("unknown.bvh"), readForImport, &window);
  dialog.show();
  const auto ready = [&] { return QTest::qWaitFor([&] { return !dialog.reading(); }, 20000); };
  ASSERT_TRUE(ready());
  const auto choose = [&](const char* joint, const QString& name) {
    auto* box = dialog.findChild<QComboBox*>(QString::fromLatin1(joint));
    ASSERT_TRUE(box);
    box->setCurrentIndex(box->findData(name));
    Q_EMIT box->activated(box->currentIndex());
    ASSERT_TRUE(ready());
  };
  const QStringList canonical = dialog.found().canonical;
  for (const QString& joint : canonical) choose(joint.toLatin1().constData(), QString());
  EXPECT_EQ(dialog.ghost()->bones(), 0);
  EXPECT_FALSE(dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->isEnabled());
  choose("pelvis", "Q1");
  choose("neck", "Q2");
  choose("shoulder_left", "Q4");
  choose("elbow_left", "Q5");
  EXPECT_GE(dialog.ghost()->bones(), 2);
  EXPECT_TRUE(dialog.hasOwnJoints());
  EXPECT_TRUE(dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->isEnabled());
  choose("elbow_right", "Q5");
  EXPECT_EQ(dialog.found().used[rowOf(dialog.found(), "elbow_left")], "") << "one point is one joint";
  EXPECT_FALSE(dialog.findChild<QLabel*>("summary")->text().isEmpty());
}

TEST_F(ImportTest, AnImportIsOneEditAndOutlivesTheFile) {
  ui::MainWindow& shown = window;
  const ui::ModalAnswer answer("import_recording", [](QWidget* widget) {
    auto* dialog = static_cast<ui::ImportDialog*>(widget);
    auto* units = dialog->findChild<QComboBox*>("units");
    units->setCurrentIndex(units->findData("m"));
    Q_EMIT units->activated(units->currentIndex());
    EXPECT_TRUE(QTest::qWaitFor([&] { return !dialog->reading(); }, 20000));
    dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
  });
  ASSERT_TRUE(opens([&] { studio.openScene(in("scene.yaml"), QString(), 0.0); })) << problem;
  ASSERT_TRUE(opens([&] { shown.imports().open(in("turn.csv")); })) << problem;
  ASSERT_TRUE(answer.answered());
  EXPECT_EQ(work().recording, in("turn.csv"));
  EXPECT_EQ(work().reading.units, "m");
  ui::Project project = window.document().project();
  project.work.reading.joint_map = in("own.map");
  project.work.reading.mirror = "sides";
  const QString here = QString::fromStdString(folder.path().string());
  const ui::Project again = ui::parseProject(ui::projectText(project, here), in("a.abstand"), here).project;
  EXPECT_EQ(again.work.reading, project.work.reading);
  EXPECT_EQ(window.document().steps().count(), 1);
}

}  // namespace import_test
}  // namespace abstand::studio
