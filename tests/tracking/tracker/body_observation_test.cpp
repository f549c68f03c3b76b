// The grid of a depth image against what was drawn into the image.
#include "tracking/tracker/body_observation.hpp"

#include <gtest/gtest.h>

#include "tests/support/no_alloc.hpp"

namespace abstand::tracking {
namespace body_observation_test {

DepthCamera cameraOf(int width, int height) {
  DepthCamera camera;
  camera.width = width;
  camera.height = height;
  camera.fx = camera.fy = 0.9 * width;
  camera.cx = 0.5 * (width - 1);
  camera.cy = 0.5 * (height - 1);
  camera.X_WC = lookingAt({2.0, 0.5, 1.0}, {0.0, 0.0, 0.8});
  return camera;
}

/// A square person before a wall (0: none), and who is the person.
struct Picture {
  DepthImage image;
  std::vector<std::uint8_t> is_person;
  std::array<PersonImage, 1> of(const DepthCamera& camera) const { return {{{&image, &camera, is_person}}}; }
};
Picture picture(const DepthCamera& camera, float person, float wall) {
  Picture p{DepthImage(camera.width, camera.height), {}};
  p.is_person.assign(p.image.z.size(), 0);
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const bool in = std::abs(u - camera.width / 2) < camera.width / 8 &&
                      std::abs(v - camera.height / 2) < camera.height / 4;
      p.image.at(u, v) = in ? person : wall;
      p.is_person[static_cast<std::size_t>(v * camera.width + u)] = in;
    }
  }
  return p;
}

TEST(BodyObservation, PointsMatchImageAndNormalsFaceCamera) {
  const DepthCamera camera = cameraOf(64, 48);
  const Picture p = picture(camera, 1.8f, 3.0f);
  BodyObservation seen;
  seen.update(p.of(camera));
  const Transform X_CW = camera.X_WC.inverse();
  ASSERT_EQ(seen.points().count, 15u * 23u);
  for (std::size_t i = 0; i < seen.points().count; ++i) {
    const Vector3d p_C = X_CW * seen.points().point(i);
    EXPECT_NEAR(p_C.z(), 1.8, 1e-5);
    // A plane across the optical axis.
    EXPECT_GT((X_CW.linear() * seen.points().normal(i)).dot(-Vector3d::UnitZ()), 0.999);
  }
}

TEST(BodyObservation, CellCountIsLimited) {
  const DepthCamera camera = cameraOf(640, 480);
  const Picture p = picture(camera, 1.8f, 3.0f);
  BodyObservation seen(1000);
  seen.update(p.of(camera));
  EXPECT_LE(seen.points().count, 1200u);
  EXPECT_GT(seen.points().count, 500u);
  for (std::size_t i = 0; i < seen.points().count; ++i)
    EXPECT_NEAR((camera.X_WC.inverse() * seen.points().point(i)).z(), 1.8, 1e-5);
}

TEST(BodyObservation, EmptyCellsHoldOffsetToPerson) {
  const DepthCamera camera = cameraOf(64, 48);
  const Picture p = picture(camera, 1.8f, 3.0f);
  BodyObservation seen;
  seen.update(p.of(camera));
  constexpr double kZ = 1.8;
  for (int v = 0; v < 48; v += 5) {
    for (int u = 0; u < 64; u += 3) {
      const BodyView::Probe probe = seen.views()[0].at(camera.at(u, v, kZ));
      const bool in = p.is_person[static_cast<std::size_t>(v * 64 + u)] != 0;
      EXPECT_EQ(probe.state, in ? CellState::kPerson : CellState::kEmpty);
      EXPECT_NEAR(probe.z, in ? 1.8 : 3.0, 1e-5);
      if (in) continue;
      double nearest = kInfinity;
      for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x)
          if (p.is_person[static_cast<std::size_t>(y * 64 + x)] != 0)
            nearest = std::min(nearest, std::hypot(x - u, y - v));
      EXPECT_NEAR(probe.to_person.norm(), nearest * kZ / camera.fx,
                  1.0 * kZ / camera.fx);  // off by a cell at most
    }
  }
}

TEST(BodyObservation, UnmeasuredPixelsAreUnknown) {
  const DepthCamera camera = cameraOf(64, 48);
  Picture p = picture(camera, 1.8f, 3.0f);
  BodyObservation seen;
  p.image.at(2, 2) = 0.0f;
  seen.update(p.of(camera));
  EXPECT_EQ(seen.views()[0].at(camera.at(2, 2, 1.0)).state, CellState::kUnknown);
  p = picture(camera, 1.8f, 0.0f);
  seen.update(p.of(camera));
  EXPECT_EQ(seen.views()[0].at(camera.at(2, 2, 1.0)).state, CellState::kEmpty);
  EXPECT_EQ(seen.views()[0].at(camera.at(-5, 2, 1.0)).state, CellState::kUnknown);
  EXPECT_EQ(seen.views()[0].at({0.0, 0.0, -1.0}).state, CellState::kUnknown);
}

TEST(BodyObservation, AllocatesNothingAfterFirstImage) {
  const DepthCamera camera = cameraOf(64, 48);
  const Picture p = picture(camera, 1.8f, 3.0f);
  BodyObservation seen;
  seen.update(p.of(camera));
  testing::NoAlloc guard;
  seen.update(p.of(camera));
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace body_observation_test
}  // namespace abstand::tracking
