// Opening, replacing and undoing with real sessions.
#include "tests/ui/studio_window.hpp"

#include <QAction>
#include <QLabel>
#include <QMessageBox>
#include <QToolButton>
#include <ctime>

#include "core/base/number.hpp"
#include "core/base/text_file.hpp"
#include "ui/document/project_file.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/selection.hpp"
#include "ui/panels/margin_panel.hpp"
#include "ui/panels/margin_row.hpp"
#include "ui/panels/timeline_panel.hpp"
#include "ui/style/actions.hpp"
#include "ui/style/format.hpp"

namespace abstand::studio {
namespace studio_window_test {

using ui::ActionId;

struct StudioDocument : StudioWindow {
  void SetUp() override {
    ASSERT_TRUE(opens([&] { window.openFile(in("scene.yaml")); })) << problem;
  }
  /// Everything that shall outlive another recording.
  void makeWork() {
    window.document().edit("work", [](ui::Work& work) {
      work.margins["anna/torso"] = 0.25;
      work.hidden.insert("wall");
    });
    window.actions()[ActionId::kTop]->trigger();
    camera = window.viewport().cameraView();
    window.selection().setObjects({0});
  }
  void expectWork() {
    EXPECT_EQ(work().margins.value("anna/torso"), 0.25);
    EXPECT_TRUE(work().hidden.contains("wall"));
    EXPECT_EQ(window.viewport().cameraView(), camera);
    EXPECT_EQ(window.selection().objects(), std::vector<int>{0});
    int row = 0;
    while (window.panels().margins->row(row) && window.panels().margins->row(row)->metres() != 0.25) ++row;
    EXPECT_TRUE(window.panels().margins->row(row)) << "no row shows the margin";
  }
  ui::CameraView camera;
};

TEST_F(StudioDocument, ChangingRecordingKeepsWorkAndCanBeUndone) {
  makeWork();
  ASSERT_TRUE(opens([&] { window.openFile(in("turn.csv")); })) << problem;
  EXPECT_EQ(work().recording, in("turn.csv"));
  expectWork();
  EXPECT_TRUE(window.windowTitle().contains("turn.csv"));
  ASSERT_TRUE(opens([&] { window.actions()[ActionId::kUndo]->trigger(); })) << problem;
  EXPECT_TRUE(work().recording.isEmpty());
  expectWork();
  ASSERT_TRUE(opens([&] { window.actions()[ActionId::kRedo]->trigger(); })) << problem;
  EXPECT_EQ(work().recording, in("turn.csv"));
}

TEST_F(StudioDocument, ReopeningSceneKeepsWorkAndTime) {
  makeWork();
  window.playback().seek(0.7);
  ASSERT_TRUE(opens([&] { window.openFile(in("scene.yaml")); })) << problem;
  expectWork();
  EXPECT_NEAR(window.playback().time(), 0.7, 0.05);
  EXPECT_TRUE(window.document().steps().canUndo());
}

TEST_F(StudioDocument, ReadingOptionsReloadRecording) {
  const double end = window.playback().end();
  ASSERT_TRUE(opens([&] {
    window.document().edit("twice as fast", [](ui::Work& work) { work.reading.speed = 2.0; });
  })) << problem;
  EXPECT_NEAR(window.playback().end(), 0.5 * end, 1e-6);
  ASSERT_TRUE(opens([&] { window.actions()[ActionId::kUndo]->trigger(); })) << problem;
  EXPECT_NEAR(window.playback().end(), end, 1e-6);
}

TEST_F(StudioDocument, UnreadableRecordingChangesNothing) {
  makeWork();
  folder.write("bad.csv", "t,foo\n0,1\n");
  EXPECT_FALSE(opens([&] { window.openFile(in("bad.csv")); }));
  EXPECT_FALSE(problem.empty());
  EXPECT_TRUE(work().recording.isEmpty());
  expectWork();
}

TEST_F(StudioDocument, FailedUndoLeavesDocumentConsistent) {
  ASSERT_TRUE(opens([&] { window.openFile(in("turn.csv")); })) << problem;
  std::filesystem::rename(folder.path() / "walk.csv", folder.path() / "gone.csv");
  EXPECT_FALSE(opens([&] { window.actions()[ActionId::kUndo]->trigger(); }));
  EXPECT_FALSE(window.panels().margins->row(0)) << "the window is empty";
  std::filesystem::rename(folder.path() / "gone.csv", folder.path() / "walk.csv");
  ASSERT_TRUE(opens([&] { window.actions()[ActionId::kRedo]->trigger(); })) << problem;
  EXPECT_TRUE(window.panels().margins->row(0));
}

TEST_F(StudioDocument, ProjectIsSavedAndOpened) {
  makeWork();
  ASSERT_TRUE(opens([&] { window.openFile(in("turn.csv")); })) << problem;
  window.playback().seek(1.1);
  ui::Project project = window.document().project();
  project.viewpoint.t = 1.1;
  ui::writeProject(project, in("p.abstand"));
  window.document().setSaved(in("p.abstand"));
  Q_EMIT window.closeRequested();
  EXPECT_TRUE(work().scene.isEmpty());
  EXPECT_TRUE(window.document().file().isEmpty());
  ASSERT_TRUE(opens([&] { window.openFile(in("p.abstand")); })) << problem;
  EXPECT_EQ(work().recording, in("turn.csv"));
  EXPECT_EQ(work().margins.value("anna/torso"), 0.25);
  EXPECT_EQ(window.viewport().cameraView(), camera);
  EXPECT_FALSE(window.document().modified());
  EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(window.playback().time() - 1.1) < 0.05; }, kLoadMs));
}

TEST_F(StudioDocument, DepthRecordingShowsProgressAndCanBeCancelled) {
  const auto depth = testing::sharedData("depth/utd_mhad/a18_s1_t1_depth.mat");
  if (!exists(depth)) GTEST_SKIP() << depth;
  makeWork();
  const auto* text = window.findChild<QLabel*>("opening");
  const QSignalSpy ready(&studio, &Studio::ready);
  window.openFile(QString::fromStdString(depth.string()));
  ASSERT_TRUE(QTest::qWaitFor([&] { return text->text().contains("Finding the person: image"); }, kLoadMs));
  window.findChild<QToolButton*>("cancel_opening")->click();
  EXPECT_FALSE(text->isVisible());
  expectWork();
  EXPECT_TRUE(work().recording.isEmpty());
  ASSERT_TRUE(opens([&] { window.openFile(in("turn.csv")); })) << problem;
  EXPECT_EQ(ready.size(), 1);
}

TEST_F(StudioWindow, OnlyNewestRequestIsShown) {
  const QSignalSpy ready(&studio, &Studio::ready);
  for (int i = 0; i < 5; ++i) studio.openScene(in("none.yaml"), {}, 0.0);
  for (int i = 0; i < 3; ++i) studio.openScene(in("scene.yaml"), {}, 0.0);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !ready.isEmpty(); }, kLoadMs));
  EXPECT_EQ(ready.size(), 1);
  EXPECT_EQ(work().scene, in("scene.yaml"));
  EXPECT_FALSE(window.findChild<QMessageBox*>()) << "nobody hears of what was abandoned";
}

TEST_F(StudioWindow, CancelledRequestIsNeverShown) {
  const QSignalSpy ready(&studio, &Studio::ready);
  studio.openScene(in("scene.yaml"), {}, 0.0);
  Q_EMIT window.cancelRequested();
  ASSERT_TRUE(opens([&] { window.openFile(in("walk.csv")); })) << problem;
  EXPECT_EQ(ready.size(), 1);
  EXPECT_TRUE(work().scene.isEmpty());
}

TEST_F(StudioWindow, RecordingAloneShowsPerson) {
  ASSERT_TRUE(opens([&] { window.openFile(in("walk.csv")); })) << problem;
  EXPECT_TRUE(work().scene.isEmpty());
  EXPECT_EQ(work().recording, in("walk.csv"));
  EXPECT_TRUE(window.panels().margins->groupRow("person"));
  ASSERT_TRUE(opens([&] { window.openFile(in("turn.csv")); })) << problem;
}

TEST_F(StudioWindow, TimeOfDayIsShownWhereItIsKnown) {
  const ui::TimelinePanel& timeline = *window.panels().timeline;
  QAction* by_clock = window.actions()[ui::ActionId::kClockTime];
  ASSERT_TRUE(opens([&] { window.openFile(in("walk.csv")); })) << problem;
  EXPECT_FALSE(by_clock->isEnabled()) << "its times begin at 0";
  std::string text = readFile(folder.path() / "walk.csv");
  constexpr std::time_t kStart = 1764150000;
  for (std::size_t line = text.find('\n') + 1; line < text.size(); line = text.find('\n', line) + 1) {
    const std::size_t comma = text.find(',', line);
    text.replace(line, comma - line, formatDouble(kStart + std::stod(text.substr(line, comma - line))));
  }
  folder.write("dated.csv", text);
  ASSERT_TRUE(opens([&] { window.openFile(in("dated.csv")); })) << problem;
  ASSERT_TRUE(by_clock->isEnabled());
  EXPECT_EQ(timeline.timeLabel()->text(), ui::secondsWithUnit(0.0));
  by_clock->setChecked(true);
  char expected[16];
  std::strftime(expected, sizeof expected, "%H:%M:%S", std::localtime(&kStart));
  EXPECT_EQ(timeline.timeLabel()->text(), QString(expected) + ".000");
  EXPECT_TRUE(timeline.timeLabel()->toolTip().contains("2025")) << "the date is in the tip";
  window.actions()[ui::ActionId::kClockTime]->setChecked(false);
  EXPECT_EQ(timeline.timeLabel()->text(), ui::secondsWithUnit(0.0));
}

TEST_F(StudioWindow, RobotAloneIsScene) {
  folder.write("arm.urdf",
               "<robot name='r'><link name='a'><collision><geometry><box size='1 1 1'/></geometry>"
               "</collision></link></robot>");
  ASSERT_TRUE(opens([&] { window.openFile(in("arm.urdf")); })) << problem;
  EXPECT_TRUE(window.panels().margins->groupRow("robot"));
}

TEST_F(StudioWindow, SceneAndRecordingTogetherAreOneDocument) {
  ASSERT_TRUE(opens([&] {
    window.openFile(in("scene.yaml"));
    window.openFile(in("turn.csv"));
  })) << problem;
  EXPECT_EQ(work().scene, in("scene.yaml"));
  EXPECT_EQ(work().recording, in("turn.csv"));
}

}  // namespace studio_window_test
}  // namespace abstand::studio
