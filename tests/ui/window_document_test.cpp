// The window edits its document and follows it: undo, project files, questions.
#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QMessageBox>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>
#include <QTreeView>

#include "core/base/text_file.hpp"
#include "tests/support/paths.hpp"
#include "tests/ui/modal_answer.hpp"
#include "tests/ui/shown_window.hpp"
#include "ui/document/document.hpp"
#include "ui/document/project_file.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/selection.hpp"
#include "ui/panels/group_panel.hpp"
#include "ui/panels/margin_panel.hpp"
#include "ui/panels/margin_row.hpp"
#include "ui/panels/scene_tree_panel.hpp"
#include "ui/project_commands.hpp"
#include "ui/style/actions.hpp"

namespace abstand::ui {
namespace window_document_test {

struct WindowDocumentTest : ShownWindow {
  void SetUp() override {
    ShownWindow::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    session.log.clear();
    hand = session.indexOf("operator/hand_left");
    qRegisterMetaType<Project>("abstand::ui::Project");
  }
  QAction* action(ActionId id) { return window.actions()[id]; }
  const Work& work() const { return window.document().work(); }
  /// As the margin panel has it.
  double shownMargin() const { return window.panels().margins->row(hand)->metres(); }
  bool setMargin(int mm) {
    window.panels().margins->row(hand)->findChild<QSlider*>()->setValue(mm);
    const double metres = mm * 1e-3;
    return QTest::qWaitFor(
        [&] { return std::abs(work().margins.value("operator/hand_left", -1.0) - metres) < 1e-9; }, kWaitMs);
  }
  void tick(int object, Qt::CheckState state) {
    auto* tree = window.findChild<SceneTreePanel*>();
    QAbstractItemModel* model = tree->model();
    for (int g = 0; g < model->rowCount(); ++g) {
      const QModelIndex group = model->index(g, 0);
      for (int r = 0; r < model->rowCount(group); ++r) {
        const QModelIndex index = model->index(r, 0, group);
        if (index.data(Qt::ToolTipRole)
                .toString()
                .startsWith(
                    QString::fromStdString(session.outline().objects[static_cast<std::size_t>(object)].name)))
          model->setData(index, state, Qt::CheckStateRole);
      }
    }
  }
  const QToolButton* floorButton() {
    const auto buttons = window.findChildren<QToolButton*>();
    return *std::find_if(buttons.begin(), buttons.end(), [&](const QToolButton* button) {
      return button->defaultAction() == action(ActionId::kFloor);
    });
  }
  /// A project whose scene and recording exist.
  QString writeFiles() {
    folder.write("scene.yaml", "abstand: 1\n");
    folder.write("walk.bvh", "HIERARCHY\n");
    Project project;
    project.work.scene = in("scene.yaml");
    project.work.recording = in("walk.bvh");
    project.work.margins["operator/hand_left"] = 0.125;
    writeProject(project, in("p.abstand"));
    return in("p.abstand");
  }
  QString in(const char* name) const { return QString::fromStdString((folder.path() / name).string()); }

  testing::ScratchFolder folder;
  int hand{-1};
};

TEST_F(WindowDocumentTest, UndoRestoresMargin) {
  const double before = shownMargin();
  ASSERT_TRUE(setMargin(123));
  EXPECT_EQ(action(ActionId::kUndo)->text(), "&Undo: margin of operator/hand_left");
  session.log.clear();
  QApplication::setActiveWindow(&window);
  QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(shownMargin(), before);
  EXPECT_EQ(session.log, std::vector<std::string>{"margin " + std::to_string(hand) + " 0.04"});
  EXPECT_FALSE(action(ActionId::kUndo)->isEnabled());
  QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_NEAR(shownMargin(), 0.123, 1e-9);
  action(ActionId::kResetMargins)->trigger();
  EXPECT_EQ(shownMargin(), before);
  EXPECT_TRUE(work().margins.isEmpty());
}

TEST_F(WindowDocumentTest, SliderDragIsOneStep) {
  auto* slider = window.panels().margins->row(hand)->findChild<QSlider*>();
  for (int drag = 1; drag <= 2; ++drag) {
    slider->setSliderDown(true);
    for (const int mm : {100 * drag, 100 * drag + 10, 100 * drag + 20}) ASSERT_TRUE(setMargin(mm));
    slider->setSliderDown(false);
  }
  EXPECT_EQ(window.document().steps().count(), 2);
  action(ActionId::kUndo)->trigger();
  EXPECT_NEAR(shownMargin(), 0.120, 1e-9);
}

TEST_F(WindowDocumentTest, UndoOfAllEditsRestoresStart) {
  const Work start = work();
  const QImage picture = window.viewport().picture();
  ASSERT_TRUE(setMargin(250));
  tick(hand, Qt::Unchecked);
  action(ActionId::kFloor)->trigger();
  action(ActionId::kVelocities)->trigger();
  Q_EMIT window.panels().groups->stateWanted(0, view::PairGroupState::kPaused);
  Q_EMIT window.panels().groups->removeWanted(3);
  Q_EMIT window.panels().groups->addWanted(1, 3);
  action(ActionId::kResetMargins)->trigger();
  EXPECT_EQ(window.document().steps().count(), 8);
  window.pull();
  EXPECT_FALSE(window.viewport().options().floor);
  EXPECT_FALSE(floorButton()->isChecked());
  EXPECT_FALSE(work() == start);
  while (action(ActionId::kUndo)->isEnabled()) action(ActionId::kUndo)->trigger();
  EXPECT_EQ(work(), start);
  EXPECT_TRUE(action(ActionId::kFloor)->isChecked());
  EXPECT_TRUE(floorButton()->isChecked());
  EXPECT_FALSE(window.isWindowModified());
  // The session is back, too: what it shows is drawn as before.
  window.pull();
  view::SceneSnapshot now;
  session.setMargin(hand, shownMargin());
  ASSERT_TRUE(session.takeSnapshot(now));
  EXPECT_EQ(now.groups[0].state, view::PairGroupState::kRunning);
  EXPECT_EQ(now.pair_group[3], 0);
  EXPECT_EQ(window.viewport().picture(), picture);
}

TEST_F(WindowDocumentTest, NewSessionKeepsUserWork) {
  ASSERT_TRUE(setMargin(99));
  tick(hand, Qt::Unchecked);
  action(ActionId::kTop)->trigger();
  const CameraView camera = window.viewport().cameraView();
  window.selection().setObjects({hand, session.indexOf("table")});
  FakeSession next;
  window.setSession(nullptr);
  window.setSession(&next);
  EXPECT_EQ(next.log.front(), "margin " + std::to_string(hand) + " 0.099");
  EXPECT_NEAR(shownMargin(), 0.099, 1e-9);
  EXPECT_EQ(window.viewport().cameraView(), camera);
  EXPECT_EQ(window.selection().objects().size(), 2u);
  EXPECT_TRUE(work().hidden.contains("operator/hand_left"));
  window.setSession(nullptr);
}

TEST_F(WindowDocumentTest, SelectedPairStaysSelected) {
  const auto [a, b] = session.outline().pairs[7];
  window.selection().setPair(7, a, b);
  FakeSession next;
  window.setSession(&next);
  EXPECT_EQ(window.selection().pair(), 7);
  window.document().open({}, QString(), false);
  window.setSession(nullptr);
}

TEST_F(WindowDocumentTest, SaveLoadSaveIsByteIdentical) {
  const QString file = writeFiles();
  window.document().open(readProject(file), file, false);
  window.setSession(&session);
  EXPECT_NEAR(shownMargin(), 0.125, 1e-12);
  tick(hand, Qt::Unchecked);
  action(ActionId::kShadows)->trigger();
  action(ActionId::kFront)->trigger();
  window.playback().seek(3.7);
  EXPECT_TRUE(window.isWindowModified());
  EXPECT_EQ(window.windowTitle(), QStringLiteral("p, walk.bvh[*] – Abstand"));
  action(ActionId::kSave)->trigger();
  EXPECT_FALSE(window.isWindowModified());
  const std::string first = readFile(file.toStdString());
  window.document().open(readProject(file), file, false);
  window.setSession(nullptr);
  window.setSession(&session);
  window.playback().seek(window.document().viewpoint().t);
  action(ActionId::kSave)->trigger();
  EXPECT_EQ(readFile(file.toStdString()), first);
}

TEST_F(WindowDocumentTest, ClosingAsksAboutUnsavedWork) {
  const QString file = writeFiles();
  window.document().open(readProject(file), file, false);
  tick(hand, Qt::Unchecked);
  {
    const auto cancel = ModalAnswer::click("unsaved_changes", "Cancel");
    EXPECT_FALSE(window.close());
    EXPECT_TRUE(cancel.answered());
  }
  {
    const auto save = ModalAnswer::click("unsaved_changes", "Save");
    EXPECT_TRUE(window.close());
    EXPECT_TRUE(save.answered());
  }
  EXPECT_TRUE(readProject(file).work.hidden.contains("operator/hand_left"));
  window.show();
  tick(hand, Qt::Checked);
  const auto discard = ModalAnswer::click("unsaved_changes", "Discard");
  EXPECT_TRUE(window.close());
  EXPECT_TRUE(discard.answered());
  EXPECT_TRUE(readProject(file).work.hidden.contains("operator/hand_left"));
}

TEST_F(WindowDocumentTest, EmptyWindowClosesWithoutQuestion) {
  window.setSession(nullptr);
  action(ActionId::kFloor)->trigger();
  EXPECT_TRUE(window.close());
}

TEST_F(WindowDocumentTest, SaveAsAddsTheEnding) {
  writeFiles();
  Project project;
  project.work.scene = in("scene.yaml");
  window.document().open(project, QString(), true);
  const auto name = ModalAnswer::choose("save_project", in("new"));
  action(ActionId::kSave)->trigger();
  EXPECT_TRUE(name.answered());
  EXPECT_EQ(window.document().file(), in("new.abstand"));
  EXPECT_EQ(readProject(in("new.abstand")).work.scene, in("scene.yaml"));
}

TEST_F(WindowDocumentTest, MissingRecordingIsLocatedOrOmitted) {
  const QString file = writeFiles();
  const QSignalSpy opened(&window, &MainWindow::openProjectRequested);
  std::filesystem::rename(folder.path() / "walk.bvh", folder.path() / "other.bvh");
  {
    const auto cancel = ModalAnswer::click("missing_file", "Cancel");
    window.openFile(file);
    EXPECT_TRUE(cancel.answered());
    EXPECT_EQ(opened.size(), 0);
  }
  {
    QString question;
    const ModalAnswer leave("missing_file", [&](QWidget* box) {
      question = static_cast<QMessageBox*>(box)->text();
      for (QAbstractButton* button : box->findChildren<QAbstractButton*>())
        if (button->text().contains("scene's recording")) return button->click();
    });
    window.openFile(file);
    ASSERT_EQ(opened.size(), 1);
    EXPECT_TRUE(question.contains(in("walk.bvh"))) << question.toStdString();
    EXPECT_TRUE(opened[0][0].value<Project>().work.recording.isEmpty());
    EXPECT_TRUE(opened[0][2].toBool()) << "it differs from the file";
  }
  const auto locate = ModalAnswer::click("missing_file", "Locate");
  const auto choose = ModalAnswer::choose("locate_file", in("other.bvh"));
  window.openFile(file);
  ASSERT_EQ(opened.size(), 2);
  EXPECT_EQ(opened[1][0].value<Project>().work.recording, in("other.bvh"));
}

TEST_F(WindowDocumentTest, RecordingOptionsAreUndoable) {
  const ModalAnswer accept("recording_options", [](QWidget* dialog) {
    auto* units = dialog->findChild<QComboBox*>("units");
    units->setCurrentIndex(units->findData("cm"));
    dialog->findChild<QDoubleSpinBox*>("speed")->setValue(1.5);
    static_cast<QDialog*>(dialog)->accept();
  });
  action(ActionId::kRecordingOptions)->trigger();
  EXPECT_TRUE(accept.answered());
  EXPECT_EQ(work().reading, (ReadingOptions{"cm", "", "", "", 1.5, false}));
  action(ActionId::kUndo)->trigger();
  EXPECT_EQ(work().reading, ReadingOptions());
  const ModalAnswer reject("recording_options",
                           [](QWidget* dialog) { static_cast<QDialog*>(dialog)->reject(); });
  action(ActionId::kRecordingOptions)->trigger();
  EXPECT_FALSE(action(ActionId::kUndo)->isEnabled());
}

TEST_F(WindowDocumentTest, ReportsDamagedProjectWithPosition) {
  folder.write("bad.abstand", "{\n  \"abstand_project\": 1,\n  \"margins\": {\"a\": -5}\n}\n");
  const QSignalSpy opened(&window, &MainWindow::openProjectRequested);
  window.openFile(in("bad.abstand"));
  const auto* box = window.findChild<QMessageBox*>();
  ASSERT_TRUE(box);
  EXPECT_TRUE(box->text().contains("bad.abstand:3:")) << box->text().toStdString();
  EXPECT_EQ(opened.size(), 0);
}

TEST_F(WindowDocumentTest, ReportsSettingsForUnknownNames) {
  Project project;
  project.work.margins["nobody/hand"] = 0.1;
  window.document().open(project, "/p.abstand", false);
  window.setSession(&session);
  const auto* box = window.findChild<QMessageBox*>();
  ASSERT_TRUE(box);
  EXPECT_TRUE(box->text().contains("nobody/hand"));
}

TEST_F(WindowDocumentTest, ReportsUnknownFileType) {
  window.openFile("/somewhere/picture.gif");
  const auto* box = window.findChild<QMessageBox*>();
  ASSERT_TRUE(box);
  EXPECT_TRUE(box->text().contains("picture.gif"));
  EXPECT_TRUE(box->text().contains(".bvh"));
}

}  // namespace window_document_test
}  // namespace abstand::ui
