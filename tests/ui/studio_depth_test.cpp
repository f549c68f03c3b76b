// The depth image beside the body, with real sessions of a rendered clip.
#include <QLabel>
#include <fstream>

#include "tests/ui/studio_depth_window.hpp"
#include "tracking/depth/camera/depth_camera.hpp"
#include "tracking/tracker/track_picture.hpp"
#include "ui/style/actions.hpp"

namespace abstand::studio {
namespace studio_depth_test {

using ui::ActionId;
using ui::JointLook;

TEST_F(StudioDepth, ImageIsThatOfMomentDrawn) {
  ASSERT_TRUE(opensClip()) << problem;
  raise();
  ASSERT_TRUE(waits());
  const auto stream = tracking::openDepthStream(clip);
  for (const std::size_t wanted : {0u, 6u, 13u, 3u}) {
    // The moments of the window are those of the images.
    ASSERT_TRUE(goesTo(stream->times()[wanted])) << wanted;
    EXPECT_EQ(shown().image, wanted);
    EXPECT_NEAR(shown().t, window.moment().t, 1e-9);
    EXPECT_TRUE(panel().caption()->text().startsWith(QStringLiteral("Image %1 of 1").arg(wanted + 1)))
        << panel().caption()->text().toStdString();
    // The pixels are those of the file.
    tracking::DepthFrame frame;
    stream->seek(wanted);
    ASSERT_TRUE(stream->next(frame));
    tracking::ColourImage grey(frame.image.width, frame.image.height);
    tracking::drawDepth(frame.image, 0, grey);
    ASSERT_EQ(shown().plain.size(), QSize(320, 240));
    long different = 0;
    for (int v = 0; v < 240; ++v)
      for (int u = 0; u < 320; ++u) {
        const auto [r, g, b] = grey.at(u, v);
        different += shown().plain.pixel(u, v) != qRgb(r, g, b);
      }
    EXPECT_EQ(different, 0);
  }
}

TEST_F(StudioDepth, EditedCameraOfTheFolderIsReadAgain) {
  ASSERT_TRUE(opensClip()) << problem;
  const auto shift = [&] {
    tracking::DepthCamera camera = tracking::loadDepthCamera(clip / "camera.yaml");
    camera.X_WC.translation().y() += 0.2;
    std::ofstream(clip / "camera.yaml") << tracking::describeDepthCamera(camera);
  };
  const auto torso = [&] {
    const auto& objects = window.moment().objects;
    return objects.empty() ? 0.0 : objects.front().X_WB.translation().y();
  };
  raise();
  ASSERT_TRUE(goesTo(at(6)));
  window.pull();
  const double before = torso();
  ASSERT_TRUE(opens(shift)) << problem;
  window.pull();
  EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(torso() - before - 0.2) < 0.02; }, kLoadMs))
      << torso() << " before " << before;
}

TEST_F(StudioDepth, JointsStandOnPerson) {
  ASSERT_TRUE(opensClip()) << problem;
  raise();
  ASSERT_TRUE(goesTo(at(12)));
  ASSERT_TRUE(shown().found);
  EXPECT_EQ(shown().joints.size(), humanmodel::kJointCount);
  // A joint is inside the body: the depth at its pixel is that of the person, who is 2.8 m away before
  // nothing.
  int on_person = 0, known = 0;
  for (const ui::DepthJoint& joint : shown().joints) {
    if (joint.look == JointLook::kUnknown) continue;
    ++known;
    const QRgb nothing = shown().plain.pixel(0, 0);
    bool near_person = false;
    for (int dv = -4; dv <= 4; ++dv)
      for (int du = -4; du <= 4; ++du) {
        const QPoint at = joint.at.toPoint() + QPoint(du, dv);
        near_person |= shown().plain.rect().contains(at) && shown().plain.pixel(at) != nothing;
      }
    on_person += near_person;
    EXPECT_GE(joint.spread, 0.0);
    const auto* under = panel().view().jointAt(panel().view().onScreen(joint));
    ASSERT_TRUE(under) << joint.name.toStdString();
    EXPECT_TRUE(ui::jointText(joint).startsWith(joint.name));
  }
  EXPECT_GE(known, 18);
  EXPECT_EQ(on_person, known) << "within 4 pixels, 39 mm";
  EXPECT_FALSE(panel().view().jointAt(QPointF(1.0, 1.0)));
  EXPECT_NE(shown().body, shown().plain);
}

TEST_F(StudioDepth, BodyIsTakenOffAndKept) {
  ASSERT_TRUE(opensClip()) << problem;
  raise();
  ASSERT_TRUE(goesTo(at(7)));
  auto& view = const_cast<ui::DepthView&>(panel().view());
  const QImage with = view.grab().toImage();
  window.actions()[ActionId::kDepthBody]->trigger();
  EXPECT_NE(view.grab().toImage(), with);
  window.actions()[ActionId::kDepthBody]->trigger();
  EXPECT_EQ(view.grab().toImage(), with);
}

TEST_F(StudioDepth, RecordingWithoutDepthImagesSaysSo) {
  ASSERT_TRUE(opens([&] { window.openFile(in("scene.yaml")); })) << problem;
  raise();
  EXPECT_TRUE(panel().view().message().contains("no depth images"));
  EXPECT_FALSE(panel().caption()->isVisible());
  EXPECT_FALSE(panel().isOfMoment());
}

TEST_F(StudioDepth, MissingImageIsReported) {
  ASSERT_TRUE(opensClip()) << problem;
  raise();
  ASSERT_TRUE(goesTo(0.0));
  std::filesystem::remove_all(clip);
  ASSERT_TRUE(goesTo(at(13)));
  EXPECT_FALSE(shown().problem.isEmpty());
  EXPECT_TRUE(shown().body.isNull()) << "not an image of another moment";
  EXPECT_EQ(panel().view().message(), shown().problem);
}

TEST_F(StudioDepth, LastRequestIsAnswered) {
  ASSERT_TRUE(opensClip()) << problem;
  ui::DepthPort* port = nullptr;
  raise();
  ASSERT_TRUE(waits());
  session::SessionOptions options;
  options.keep_fits = true;
  options.recording = clip;
  auto session = depth::openSession(scene_file::loadScene((folder.path() / "scene.yaml").string()), options);
  DepthPictures pictures(depthPeople(*session));
  port = &pictures;
  ASSERT_EQ(port->people().size(), 1u);
  EXPECT_EQ(port->people()[0].images, 16u);
  for (std::size_t round = 0; round < 3; ++round)
    for (std::size_t i = 0; i < 16; ++i) port->ask(0, i);
  ui::DepthPicture picture;
  EXPECT_TRUE(QTest::qWaitFor([&] { return port->take(picture) && picture.image == 15; }, kLoadMs));
  QTest::qWait(100);
  EXPECT_FALSE(port->take(picture)) << "nothing comes after the last one";
}

TEST_F(StudioDepth, SessionTimeFollowsSpeed) {
  session::SessionOptions options;
  options.keep_fits = true;
  options.recording = clip;
  options.person_speed = 2.0;
  auto session = depth::openSession(scene_file::loadScene((folder.path() / "scene.yaml").string()), options);
  const std::vector<DepthPerson> people = depthPeople(*session);
  ASSERT_EQ(people.size(), 1u);
  EXPECT_EQ(people[0].speed, 2.0);
  const DepthPictures pictures(people);
  // Image i was taken at i / 15 s and is shown at half of that.
  for (std::size_t i = 0; i < 16; ++i) {
    const double t = people[0].clip->times[i] / 2.0;
    EXPECT_EQ(pictures.imageAt(0, t), i);
    EXPECT_EQ(pictures.imageAt(0, t + 0.4 / kRate), i);
  }
}

}  // namespace studio_depth_test
}  // namespace abstand::studio
