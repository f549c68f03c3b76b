// A range of a recording as a video file.
#include <gtest/gtest.h>

#include <QAction>
#include <QFileInfo>
#include <QProgressDialog>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <opencv2/videoio.hpp>

#include "app/studio/studio.hpp"
#include "tests/app/tune/slide_scene.hpp"
#include "tests/ui/modal_answer.hpp"
#include "ui/document/document.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/time_axis.hpp"
#include "ui/style/actions.hpp"
#include "ui/video_recorder.hpp"
#include "ui/viewport/opengl.hpp"
#include "ui/viewport/viewport.hpp"

namespace abstand::studio {
namespace studio_video_test {

constexpr int kLimitMs = 240000;  // nothing takes so long, under a sanitizer either

struct StudioVideo : ::testing::Test {
  void SetUp() override {
    if (!ui::openGlInfo().available) GTEST_SKIP() << "no OpenGL 3.2 here";
    QSettings().clear();
    qputenv("ABSTAND_CACHE", (folder.path() / "cache").c_str());
    scene = testing::writeSlide(folder, {.robot = 0.5, .person = 0.3, .stops_at = 1.8, .seconds = 4.0});
    file = QString::fromStdString((folder.path() / "clip.avi").string());
    window.resize(700, 600);
    window.show();
    studio = std::make_unique<Studio>(window);
    QSignalSpy ready(studio.get(), &Studio::ready);
    studio->openScene(QString::fromStdString(scene.string()), {}, 0.0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !ready.isEmpty(); }, kLimitMs));
    window.playback().seek(3.0);
    window.timeAxis().setRange(ui::TimeRange{1.0, 2.0});
  }
  bool recorded() {
    return QTest::qWaitFor([this] { return !window.videos().recording(); }, kLimitMs);
  }

  testing::ScratchFolder folder;
  std::filesystem::path scene;
  QString file;
  ui::MainWindow window;
  std::unique_ptr<Studio> studio;
};

TEST_F(StudioVideo, HasFramesBetweenInAndOut) {
  auto answer = ui::ModalAnswer::choose(QStringLiteral("save_video"), file);
  window.actions()[ui::ActionId::kVideo]->trigger();
  EXPECT_TRUE(answer.answered());
  ASSERT_TRUE(recorded());
  cv::VideoCapture video(file.toStdString(), cv::CAP_OPENCV_MJPEG);
  ASSERT_TRUE(video.isOpened());
  EXPECT_NEAR(video.get(cv::CAP_PROP_FPS), 25.0, 0.01);
  cv::Mat picture, first, last;
  int count = 0;
  while (video.read(picture)) {
    if (count++ == 0) first = picture.clone();
    last = picture.clone();
  }
  EXPECT_EQ(count, 26) << "from 1 s to 2 s, every fourth of 100 frames a second";
  const QSize size = window.viewport().picture().size();
  EXPECT_EQ(first.cols, size.width() & ~1);
  EXPECT_EQ(first.rows, size.height() & ~1);
  EXPECT_GT(cv::norm(first, last, cv::NORM_L1) / static_cast<double>(first.total()), 0.5)
      << "the robot moves";
  EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(window.playback().time() - 3.0) < 1e-6; }, kLimitMs));
}

TEST_F(StudioVideo, LeavesNothingWhenCancelled) {
  window.videos().start(file, {0.0, 4.0});
  ASSERT_TRUE(window.videos().recording());
  auto* wait = window.findChild<QProgressDialog*>(QStringLiteral("video_wait"));
  ASSERT_TRUE(wait);
  ASSERT_TRUE(QTest::qWaitFor([&] { return wait->value() > 3; }, kLimitMs));
  wait->findChild<QPushButton*>()->click();
  EXPECT_FALSE(window.videos().recording());
  EXPECT_FALSE(QFileInfo::exists(file));
  EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(window.playback().time() - 3.0) < 1e-6; }, kLimitMs));
}

TEST_F(StudioVideo, ReportsReasonForFailure) {
  QSignalSpy failed(&window.videos(), &ui::VideoRecorder::failed);
  window.videos().start(file.chopped(4) + QStringLiteral(".mp4"), {0.0, 1.0});
  ASSERT_EQ(failed.size(), 1);
  EXPECT_TRUE(failed.front()[1].toString().contains(QLatin1String("expected .avi")));
  window.videos().start(QStringLiteral("/nowhere/clip.avi"), {0.0, 1.0});
  EXPECT_EQ(failed.size(), 2);
  EXPECT_FALSE(window.videos().recording());
}

TEST_F(StudioVideo, ClosingSessionEndsIt) {
  window.videos().start(file, {0.0, 4.0});
  studio->close();
  EXPECT_FALSE(window.videos().recording());
  EXPECT_FALSE(QFileInfo::exists(file));
  EXPECT_FALSE(window.actions()[ui::ActionId::kVideo]->isEnabled());
}

}  // namespace studio_video_test
}  // namespace abstand::studio
