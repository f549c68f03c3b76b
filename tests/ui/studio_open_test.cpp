// Opens files of any kind on an empty window, several at once.
#include <QAction>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QProcess>
#include <QUrl>

#include "tests/ui/modal_answer.hpp"
#include "tests/ui/studio_window.hpp"
#include "ui/document/project_file.hpp"
#include "ui/file_commands.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/recording_review.hpp"
#include "ui/panels/margin_panel.hpp"
#include "ui/panels/margin_row.hpp"
#include "ui/style/actions.hpp"

namespace abstand::studio {
namespace studio_open_test {

using ui::ActionId;

constexpr char kArm[] =
    "<robot name='r'><link name='a'><collision><geometry><box size='0.2 0.2 1'/></geometry>"
    "</collision></link></robot>";
/// A tetrahedron with edges of `size` along the axes.
std::string tetrahedron(const std::string& size) {
  return "v 0 0 0\nv " + size + " 0 0\nv 0 " + size + " 0\nv 0 0 " + size +
         "\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
}

struct StudioOpen : StudioWindow {
  StudioOpen() {
    folder.write("arm.urdf", kArm);
    folder.write("post.urdf", kArm);
    folder.write("crate.obj", tetrahedron("0.5"));
    folder.write("large.obj", tetrahedron("500"));
    folder.write("broken.obj", "v 0 0 0\n");
    folder.write("note.docx", "text");
  }
  QStringList all(std::initializer_list<const char*> names) const {
    QStringList files;
    for (const char* name : names) files << in(name);
    return files;
  }
  /// Names of the bodies that are shown.
  QStringList bodies() const {
    QStringList names;
    for (int i = 0; const ui::MarginRow* row = window.panels().margins->row(i); ++i)
      names << row->findChild<QLabel*>()->text();
    return names;
  }
  std::string said() const {
    const auto* box = window.findChild<QMessageBox*>();
    return box ? box->text().toStdString() : "";
  }
  bool opensAll(std::initializer_list<const char*> names) {
    return opens([&] { window.files().open(all(names)); });
  }
};

TEST_F(StudioOpen, RobotAndRecordingAreOneScene) {
  ASSERT_TRUE(opensAll({"turn.csv", "arm.urdf"})) << problem;
  EXPECT_EQ(work().scene, in("arm.urdf"));
  EXPECT_EQ(work().recording, in("turn.csv"));
  EXPECT_TRUE(window.panels().margins->groupRow("robot"));
  EXPECT_TRUE(window.panels().margins->groupRow("person"));
  EXPECT_NEAR(window.playback().end() - window.playback().start(), 1.9, 1e-6) << "of the recording";
  EXPECT_TRUE(window.review().available()) << "a person beside a robot is analysed";
}

TEST_F(StudioOpen, RecordingAndRobotMayFollowEachOther) {
  ASSERT_TRUE(opensAll({"turn.csv"})) << problem;
  ASSERT_TRUE(opensAll({"arm.urdf"})) << problem;
  EXPECT_EQ(work().recording, in("turn.csv"));
  EXPECT_TRUE(window.panels().margins->groupRow("robot"));
  EXPECT_TRUE(window.panels().margins->groupRow("person"));
  ASSERT_TRUE(opens([&] { window.actions()[ActionId::kUndo]->trigger(); })) << problem;
  EXPECT_FALSE(window.panels().margins->groupRow("robot"));
  EXPECT_TRUE(window.panels().margins->groupRow("person"));
}

TEST_F(StudioOpen, MeshesAreThingsOfTheScene) {
  ASSERT_TRUE(opensAll({"crate.obj", "large.obj"})) << problem;
  EXPECT_TRUE(work().scene.isEmpty());
  EXPECT_EQ(bodies(), QStringList({"crate", "large"}));
  EXPECT_NEAR(window.moment().objects[1].p_WCom.x(), 0.125, 1e-3) << "500 is taken for millimetres";
  ASSERT_TRUE(opensAll({"scene.yaml"})) << problem;
  ASSERT_TRUE(opensAll({"crate.obj"})) << problem;
  EXPECT_TRUE(bodies().contains("crate"));
  EXPECT_TRUE(bodies().contains("wall")) << "the mesh is added";
  ASSERT_TRUE(opens([&] { window.actions()[ActionId::kUndo]->trigger(); })) << problem;
  EXPECT_FALSE(bodies().contains("crate"));
}

TEST_F(StudioOpen, SceneTakesRobotsMeshesAndRecording) {
  ASSERT_TRUE(opensAll({"crate.obj", "arm.urdf", "turn.csv", "scene.yaml", "post.urdf"})) << problem;
  EXPECT_EQ(work().scene, in("scene.yaml"));
  EXPECT_EQ(work().added_files, all({"crate.obj", "arm.urdf", "post.urdf"}));
  for (const char* group : {"arm", "post", "anna"})
    EXPECT_TRUE(window.panels().margins->groupRow(group)) << group;
  EXPECT_TRUE(bodies().contains("crate"));
}

TEST_F(StudioOpen, FilesThatCannotBeOpenedAreNamedAndTheOthersOpen) {
  ASSERT_TRUE(opensAll({"gone.urdf", "note.docx", "arm.urdf", "turn.csv", "walk.csv"})) << problem;
  const std::string sentences = said();
  EXPECT_NE(sentences.find("gone.urdf was not found."), std::string::npos) << sentences;
  EXPECT_NE(sentences.find("note.docx is no file that this program opens"), std::string::npos) << sentences;
  EXPECT_EQ(QString::fromStdString(sentences).split('\n').size(), 2) << sentences;
  EXPECT_EQ(work().scene, in("arm.urdf"));
  EXPECT_EQ(work().recording, in("turn.csv"));
  EXPECT_EQ(work().recordings, all({"turn.csv", "walk.csv"})) << "the other can be chosen";
}

TEST_F(StudioOpen, DamagedFilesAreLeftOut) {
  folder.write("bad.csv", "t,foo\n0,1\n");
  folder.write("bad.urdf", "<robot");
  const QSignalSpy left_out(&studio, &Studio::leftOut);
  ASSERT_TRUE(opensAll({"bad.urdf", "bad.csv", "broken.obj", "crate.obj"})) << problem;
  EXPECT_EQ(bodies(), QStringList({"crate"}));
  EXPECT_TRUE(work().scene.isEmpty());
  EXPECT_TRUE(work().recording.isEmpty());
  ASSERT_EQ(left_out.size(), 1);
  const QStringList sentences = left_out[0][0].toStringList();
  ASSERT_EQ(sentences.size(), 3);
  for (const char* name : {"bad.urdf", "bad.csv", "broken.obj"})
    EXPECT_EQ(sentences.filter(in(name)).size(), 1) << name << sentences.join('\n').toStdString();
}

TEST_F(StudioOpen, NothingToOpenIsSaid) {
  EXPECT_FALSE(window.files().open(all({"gone.urdf", "note.docx"})));
  EXPECT_NE(said().find("gone.urdf was not found."), std::string::npos);
}

TEST_F(StudioOpen, MarginsOfABatchAreForItsScene) {
  folder.write("margins.yaml", "abstand_margins: 1\ndefault: {margin: 0.3}\n");
  ASSERT_TRUE(opensAll({"margins.yaml", "arm.urdf", "turn.csv"})) << problem;
  EXPECT_TRUE(QTest::qWaitFor([&] { return !work().margins.isEmpty(); }, kLoadMs)) << said();
}

TEST_F(StudioOpen, DroppedFilesAreOneScene) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(in("turn.csv")), QUrl::fromLocalFile(in("crate.obj")),
                QUrl::fromLocalFile(in("arm.urdf"))});
  QDragEnterEvent enter(QPoint(100, 100), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window, &enter);
  ASSERT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(100, 100), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  ASSERT_TRUE(opens([&] { QApplication::sendEvent(&window, &drop); })) << problem;
  EXPECT_TRUE(window.panels().margins->groupRow("robot"));
  EXPECT_TRUE(window.panels().margins->groupRow("person"));
  EXPECT_TRUE(bodies().contains("crate"));
}

TEST_F(StudioOpen, DepthFolderOpensFromTheMenu) {
  const auto depth = testing::sharedData("depth/tum");
  QStringList clips;
  std::error_code none;
  for (const auto& each : std::filesystem::directory_iterator(testing::sharedData("depth"), none))
    if (each.is_directory() && exists(each.path() / "depth.txt"))
      clips << QString::fromStdString(each.path().string());
  const QString clip = clips.value(0, in("clip"));
  if (clips.isEmpty()) std::filesystem::create_directory(folder.path() / "clip");
  const ui::ModalAnswer answer = ui::ModalAnswer::choose("open_depth_folder", clip);
  const QSignalSpy wanted(&window, &ui::MainWindow::openRecordingRequested);
  window.actions()[ActionId::kOpenDepthFolder]->trigger();
  EXPECT_TRUE(answer.answered());
  ASSERT_EQ(wanted.size(), 1);
  EXPECT_EQ(wanted[0][0].toString(), clip);
  Q_EMIT window.cancelRequested();
}

TEST_F(StudioOpen, ProjectKeepsAddedFiles) {
  ASSERT_TRUE(opensAll({"crate.obj", "arm.urdf", "turn.csv"})) << problem;
  ui::writeProject(window.document().project(), in("p.abstand"));
  window.document().setSaved(in("p.abstand"));
  Q_EMIT window.closeRequested();
  EXPECT_TRUE(bodies().isEmpty());
  ASSERT_TRUE(opensAll({"p.abstand"})) << problem;
  EXPECT_EQ(work().added_files, all({"crate.obj"}));
  EXPECT_TRUE(bodies().contains("crate"));
  EXPECT_FALSE(window.document().modified());
}

/// The program itself, with several files.
TEST_F(StudioOpen, CommandLineTakesSeveralFiles) {
  QProcess program;
  program.start(ABSTAND_STUDIO, all({"turn.csv", "gone.stl", "arm.urdf", "crate.obj"}) +
                                    QStringList{"--screenshot", in("p.png")});
  ASSERT_TRUE(program.waitForFinished(kLoadMs));
  const QString words = QString::fromUtf8(program.readAllStandardError());
  EXPECT_EQ(program.exitCode(), 0) << words.toStdString();
  EXPECT_TRUE(words.contains("gone.stl was not found.")) << words.toStdString();
  EXPECT_TRUE(exists(folder.path() / "p.png"));
  program.start(ABSTAND_STUDIO, all({"gone.stl", "note.docx"}) + QStringList{"--screenshot", in("q.png")});
  ASSERT_TRUE(program.waitForFinished(kLoadMs));
  EXPECT_EQ(program.exitCode(), 3);
  EXPECT_FALSE(exists(folder.path() / "q.png"));
}

}  // namespace studio_open_test
}  // namespace abstand::studio
