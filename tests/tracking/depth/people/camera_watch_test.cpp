// A camera that is moved or hangs is told from people who come and go before it.
#include "tracking/depth/people/camera_watch.hpp"

#include <gtest/gtest.h>

#include "core/math/transform.hpp"
#include "tests/tracking/tracker/small_camera.hpp"
#include "tracking/depth/simulator/depth_render.hpp"
#include "tracking/depth/simulator/kinect_noise.hpp"

namespace abstand::tracking {
namespace camera_watch_test {

constexpr double kStep = 1.0 / 30.0;  // s

geometry::TriangleMesh rectangle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  return {{a, b, c, a + c - b}, {{0, 1, 2}, {0, 2, 3}}};
}

/// A floor, a wall, and a screen of 0.7 m by 1.8 m at y, as seen with a Kinect's noise.
DepthImage room(const DepthCamera& camera, double screen_y, std::uint64_t image) {
  DepthRender render(camera);
  render.clear();
  const Transform X_CW = camera.X_WC.inverse();
  render.draw(rectangle({3.0, -4.0, 0.0}, {3.0, 4.0, 0.0}, {-1.5, 4.0, 0.0}), X_CW);
  render.draw(rectangle({-1.5, -4.0, 0.0}, {-1.5, 4.0, 0.0}, {-1.5, 4.0, 3.0}), X_CW);
  render.draw(
      rectangle({0.0, screen_y - 0.35, 0.0}, {0.0, screen_y + 0.35, 0.0}, {0.0, screen_y + 0.35, 1.8}), X_CW);
  return seenByKinect(render.image(), camera, kinectNoiseIn(camera), 1, image);
}

/// movedAt() of a camera that stands at `second` from 1 s on, while the screen goes through the image.
double movedAt(const DepthCamera& second) {
  const DepthCamera first = smallCameraAt({2.8, 0.0, 1.2}, {0.0, 0.0, 0.9});
  CameraWatch watch(first);
  const std::vector<std::uint8_t> nobody(static_cast<std::size_t>(first.width * first.height), 0);
  for (int i = 0; i < 60; ++i) {
    const double t = i * kStep;
    watch.see(t, room(t < 1.0 - 1e-9 ? first : second, 3.0 - 3.0 * t, static_cast<std::uint64_t>(i)), nobody);
  }
  EXPECT_EQ(watch.repeated(), 0u);
  return watch.movedAt();
}

TEST(CameraWatch, SaysWhenACameraWasPushed) {
  EXPECT_NEAR(movedAt(smallCameraAt({2.8, 0.0, 1.2}, {0.0, 0.0, 0.75})), 1.0, kStep) << "3 degrees down";
  EXPECT_NEAR(movedAt(smallCameraAt({2.8, 0.0, 1.2}, {0.0, 0.0, 1.05})), 1.0, kStep) << "3 degrees up";
  EXPECT_NEAR(movedAt(smallCameraAt({2.5, 0.0, 1.2}, {-0.3, 0.0, 0.9})), 1.0, kStep) << "0.3 m nearer";
}

/// In front of a wall, where the depths in the middle of the image stay.
TEST(CameraWatch, SaysWhenACameraWasTurnedSideways) {
  constexpr double kHidden = 0.5;  // s, in which the screen hides one side
  for (const double degrees : {-8.0, -3.0, 2.0, 5.0}) {
    const double aside = 2.8 * std::tan(unit::deg(degrees));
    EXPECT_NEAR(movedAt(smallCameraAt({2.8, 0.0, 1.2}, {0.0, aside, 0.9})), 1.0, kHidden) << degrees;
  }
  DepthCamera rolled = smallCameraAt({2.8, 0.0, 1.2}, {0.0, 0.0, 0.9});
  rolled.X_WC.linear() *= Eigen::AngleAxisd(unit::deg(4.0), Vector3d::UnitZ()).toRotationMatrix();
  EXPECT_NEAR(movedAt(rolled), 1.0, kHidden);
}

/// What is pushed along the wall, as a table, could be a camera that moves the other way.
TEST(CameraWatch, SaysNothingOfAThingThatIsPushed) {
  const DepthCamera camera = smallCameraAt({2.8, 0.0, 1.2}, {0.0, 0.0, 0.9});
  CameraWatch watch(camera);
  const std::vector<std::uint8_t> nobody(static_cast<std::size_t>(camera.width * camera.height), 0);
  for (int i = 0; i < 90; ++i) {
    const double t = i * kStep;
    watch.see(t, room(camera, std::clamp(0.5 * (t - 1.0), 0.0, 0.6) - 0.3, static_cast<std::uint64_t>(i)),
              nobody);
  }
  EXPECT_EQ(watch.movedAt(), kInfinity);
}

/// A chair that is put elsewhere is static there: it must not count as a change for a whole day.
TEST(CameraWatch, LearnsWhatStandsElsewhere) {
  const DepthCamera first = smallCameraAt({2.8, 0.0, 1.2}, {0.0, 0.0, 0.9});
  const DepthCamera pushed = smallCameraAt({2.8, 0.0, 1.2}, {0.0, 0.0, 0.75});
  CameraWatch watch(first);
  const std::vector<std::uint8_t> nobody(static_cast<std::size_t>(first.width * first.height), 0);
  double t = 0.0;
  for (int i = 0; i < 300; ++i, t += kStep)
    watch.see(t, room(first, i < 60 ? -1.0 : 1.0, static_cast<std::uint64_t>(i)), nobody);
  EXPECT_EQ(watch.movedAt(), kInfinity);
  const double pushed_at = t;
  for (int i = 0; i < 30; ++i, t += kStep)
    watch.see(t, room(pushed, 1.0, static_cast<std::uint64_t>(i)), nobody);
  EXPECT_NEAR(watch.movedAt(), pushed_at, kStep);
}

TEST(CameraWatch, SaysNothingOfOneBeforeWhichSomethingComesAndGoes) {
  EXPECT_EQ(movedAt(smallCameraAt({2.8, 0.0, 1.2}, {0.0, 0.0, 0.9})), kInfinity);
}

TEST(CameraWatch, CountsRepeatedImages) {
  const DepthCamera camera = smallCameraAt({2.8, 0.0, 1.2}, {0.0, 0.0, 0.9});
  CameraWatch watch(camera);
  const std::vector<std::uint8_t> nobody(static_cast<std::size_t>(camera.width * camera.height), 0);
  for (int i = 0; i < 9; ++i) {
    watch.see(i * kStep, room(camera, 3.0, static_cast<std::uint64_t>(std::min(i, 5))), nobody);
    EXPECT_EQ(watch.unchangedSince(), i > 5 ? 5 * kStep : kInfinity) << i;
  }
  EXPECT_EQ(watch.repeated(), 3u);
  watch.see(9 * kStep, room(camera, 3.0, 9), nobody);
  EXPECT_EQ(watch.unchangedSince(), kInfinity);
}

}  // namespace camera_watch_test
}  // namespace abstand::tracking
