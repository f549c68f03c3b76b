// Cameras placed by the room that another camera sees, too.
#include "tracking/depth/calibration/room_pose.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.hpp"
#include "core/geometry/shape.hpp"
#include "core/math/random.hpp"
#include "tests/tracking/depth/calibration/pose_errors.hpp"
#include "tracking/depth/calibration/cloud_registration.hpp"
#include "tracking/depth/calibration/still_image.hpp"
#include "tracking/depth/simulator/depth_render.hpp"
#include "tracking/depth/simulator/kinect_noise.hpp"

namespace abstand::testing {
namespace room_pose_test {

struct Box {
  Vector3d size;
  Transform X_WB;
};

/// A floor, up to two walls, and objects that depend on the seed.
struct RoomPlan {
  int walls{2};
  bool objects{true};
};

std::vector<Box> roomOf(const RoomPlan& plan, std::uint64_t seed) {
  Random random(seed, 7);
  std::vector<Box> boxes;
  const auto add = [&](const Vector3d& size, const Vector3d& p, double yaw) {
    boxes.push_back({size, fromXyzRpy(p, {0.0, 0.0, yaw})});
  };
  add({10.0, 10.0, 0.02}, {0.0, 0.0, -0.01}, 0.0);
  if (plan.walls > 0) add({0.02, 10.0, 4.0}, {-1.8, 0.0, 2.0}, 0.0);
  if (plan.walls > 1) add({10.0, 0.02, 4.0}, {0.0, -1.8, 2.0}, 0.0);
  if (!plan.objects) return boxes;
  const double x = random.between(-1.4, -1.0), y = random.between(0.1, 0.7);
  add({0.7, 1.4, 0.9}, {x, y, 0.45}, random.between(-0.2, 0.2));
  for (int i = 0; i < 4; ++i) {
    const double height = random.between(0.25, 0.9), width = random.between(0.2, 0.6);
    const double at_x = random.between(-1.4, 0.9), at_y = random.between(-1.4, 1.4);
    add({width, random.between(0.2, 0.6), height}, {at_x, at_y, 0.5 * height}, random.between(0.0, 1.5));
  }
  return boxes;
}

/// Two cameras 2.2 to 3 m from the room's middle, 30 to 60 degrees from each other.
std::array<tracking::DepthCamera, 2> camerasOf(std::uint64_t seed, int width) {
  Random random(seed, 3);
  const double middle = random.between(0.3, 1.2), angle = unit::deg(random.between(30.0, 60.0));
  std::array<tracking::DepthCamera, 2> cameras;
  for (int i = 0; i < 2; ++i) {
    tracking::DepthCamera& camera = cameras[static_cast<std::size_t>(i)];
    camera.width = width;
    camera.height = width * 3 / 4;
    camera.fx = camera.fy = 580.0 * width / 640.0;
    camera.cx = 0.5 * (camera.width - 1);
    camera.cy = 0.5 * (camera.height - 1);
    const double phi = middle + (i - 0.5) * angle, d = random.between(2.2, 3.0);
    const Vector3d eye(d * std::cos(phi) - 0.3, d * std::sin(phi) - 0.3, random.between(1.4, 2.4));
    const double x = random.between(-0.6, -0.1), y = random.between(-0.6, -0.1);
    camera.X_WC = tracking::lookingAt(eye, {x, y, random.between(0.4, 0.9)});
  }
  return cameras;
}

/// What a Kinect sees of the boxes in `images` images.
tracking::DepthImage seen(const tracking::DepthCamera& camera, const std::vector<Box>& boxes,
                          std::uint64_t seed, int images) {
  tracking::DepthRender render(camera);
  const Transform X_CW = camera.X_WC.inverse();
  for (const Box& box : boxes)
    render.draw(geometry::tessellate(geometry::Cuboid{box.size}, 1e-3), X_CW * box.X_WB);
  std::vector<tracking::DepthImage> noisy;
  for (int i = 0; i < images; ++i)
    noisy.push_back(tracking::seenByKinect(render.image(), camera, tracking::kinectNoiseIn(camera), seed,
                                           static_cast<std::uint64_t>(i)));
  return tracking::stillImage(noisy);
}

constexpr double kMove = 0.1, kTurn = unit::deg(10.0);

struct Case {
  tracking::RoomView known, camera;
  Transform truth;
};

Case caseOf(const RoomPlan& plan, std::uint64_t seed, int width, int images, double move = kMove,
            double turn = kTurn) {
  auto [known, camera] = camerasOf(seed, width);
  const std::vector<Box> boxes = roomOf(plan, seed);
  const tracking::DepthImage of_known = seen(known, boxes, 2 * seed, images),
                             of_camera = seen(camera, boxes, 2 * seed + 1, images);
  const Transform truth = camera.X_WC;
  camera.X_WC = wrong(truth, move, turn, seed);
  return {tracking::RoomView(known, of_known), tracking::RoomView(camera, of_camera), truth};
}

/// What a fit says that refuses.
std::string refusal(const tracking::RoomView& known, const tracking::RoomView& camera) {
  try {
    tracking::fitPoseToRoom(known, camera);
  } catch (const UsageError& e) {
    return e.what();
  }
  return "taken";
}

TEST(RoomPose, RecoversPoseFromWrongStarts) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    const Case c = caseOf({}, seed, 160, 3);
    const tracking::RoomFit fit = tracking::fitPoseToRoom(c.known, c.camera);
    // A Kinect's step at 3 m is 26 mm; 10,000 points and more leave a part of it.
    EXPECT_LT((fit.X_WC.translation() - c.truth.translation()).norm(), 0.01) << seed;
    EXPECT_LT(angleBetween(fit.X_WC, c.truth), unit::deg(0.3)) << seed;
    EXPECT_GT(fit.agreeing, 0.95) << seed;
    EXPECT_GT(fit.shared, 0.3) << seed;
    EXPECT_NEAR(fit.moved, kMove, 0.01) << seed;
    EXPECT_NEAR(fit.turned, kTurn, unit::deg(0.3)) << seed;
    // What is said of a point 1 m from the middle of the points holds.
    const Vector3d p_C(0.2, 0.1, 2.0);
    EXPECT_LT((fit.X_WC * p_C - c.truth * p_C).norm(), 3.0 * std::sqrt(3.0) * fit.spread) << seed;
  }
}

TEST(RoomPose, IsDeterministicAndAddsSpreadOfKnownCamera) {
  const Case c = caseOf({}, 1, 160, 3);
  const tracking::RoomFit fit = tracking::fitPoseToRoom(c.known, c.camera);
  auto [known, camera] = camerasOf(1, 160);
  known.spread = 0.02;
  const tracking::RoomView uncertain(known, seen(known, roomOf({}, 1), 2, 3));
  const tracking::RoomFit again = tracking::fitPoseToRoom(uncertain, c.camera);
  EXPECT_EQ(again.X_WC.matrix(), fit.X_WC.matrix());
  EXPECT_NEAR(again.spread, std::hypot(fit.spread, 0.02), 1e-12);
}

TEST(RoomPose, RejectsUndeterminedDegreesOfFreedom) {
  const Case floor = caseOf({.walls = 0, .objects = false}, 1, 160, 5);
  EXPECT_THAT(refusal(floor.known, floor.camera),
              ::testing::HasSubstr("do not determine every degree of freedom"));
  // The noise of single images does not count as a determination.
  const Case wall = caseOf({.walls = 1, .objects = false}, 2, 160, 1);
  EXPECT_THAT(refusal(wall.known, wall.camera),
              ::testing::HasSubstr("do not determine every degree of freedom"));
}

TEST(RoomPose, RejectsViewsWithoutOverlapAndChangedRooms) {
  const Case c = caseOf({}, 1, 160, 3);
  auto [known, camera] = camerasOf(1, 160);
  // A camera that looks at the other side of the room.
  tracking::DepthCamera away = camera;
  away.X_WC = camera.X_WC * Eigen::AngleAxisd(kPi, Vector3d::UnitY());
  EXPECT_THAT(refusal(c.known, tracking::RoomView(away, seen(away, roomOf({}, 1), 5, 3))),
              ::testing::StartsWith("--room: found "));
  // Large boxes that only one camera saw.
  std::vector<Box> changed = roomOf({}, 1);
  for (const double x : {-1.0, 0.0})
    changed.push_back({{0.6, 0.6, 1.8}, fromXyzRpy({x, -x - 1.0, 0.9}, Vector3d::Zero())});
  EXPECT_THAT(refusal(c.known, tracking::RoomView(camera, seen(camera, changed, 6, 3))),
              ::testing::StartsWith("--room: found that the cameras agree on"));
  const tracking::DepthImage nothing(160, 120);
  EXPECT_THAT(refusal(c.known, tracking::RoomView(camera, nothing)),
              ::testing::HasSubstr("found 0 points that both cameras see"));
}

TEST(StillImage, ContainsWhatStandsStill) {
  std::vector<tracking::DepthImage> images;
  for (int i = 0; i < 10; ++i) {
    tracking::DepthImage image(6, 1);
    image.at(0, 0) = i % 2 ? 2.99f : 3.01f;                // noise
    image.at(1, 0) = i < 3 ? 1.5f : 3.0f;                  // someone passes
    image.at(2, 0) = i < 4 ? 0.0f : 3.0f;                  // often measured
    image.at(3, 0) = i < 6 ? 0.0f : 3.0f;                  // seldom measured
    image.at(4, 0) = 1.0f + 0.3f * static_cast<float>(i);  // never the same
    images.push_back(image);
  }
  const tracking::DepthImage still = tracking::stillImage(images);
  EXPECT_NEAR(still.at(0, 0), 3.0f, 1e-5f);
  EXPECT_NEAR(still.at(1, 0), 3.0f, 1e-6f);
  EXPECT_NEAR(still.at(2, 0), 3.0f, 1e-6f);
  EXPECT_EQ(still.at(3, 0), 0.0f);
  EXPECT_EQ(still.at(4, 0), 0.0f);
  EXPECT_EQ(still.at(5, 0), 0.0f) << "nothing measured";
}

TEST(RoomView, NormalsAreThoseOfThePlanes) {
  auto [known, camera] = camerasOf(3, 160);
  const tracking::RoomView view(known, seen(known, roomOf({.walls = 1, .objects = false}, 3), 1, 5));
  EXPECT_GT(view.points().size(), 5000u);
  std::size_t off = 0;
  for (const tracking::RoomPoint& point : view.points()) {
    const Vector3d n_W = known.X_WC.linear() * point.n_C, p_W = known.X_WC * point.p_C;
    EXPECT_LT(n_W.dot(p_W - known.X_WC.translation()), 0.0) << "towards the camera";
    off += std::max(n_W.z(), n_W.x()) < std::cos(unit::deg(10.0));
    EXPECT_EQ(view.at(point.p_C) != nullptr, true);
  }
  EXPECT_LT(static_cast<double>(off), 0.03 * static_cast<double>(view.points().size()))
      << "but along the edge";
  EXPECT_EQ(view.at({0.0, 0.0, -1.0}), nullptr);
  EXPECT_EQ(view.at({5.0, 0.0, 1.0}), nullptr);
}

TEST(CloudRegistration, AlignsMovedCornerAndKeepsStartOfEmptyClouds) {
  std::vector<Vector3d> source, target;
  const Transform X_TS = fromXyzRpy({0.1, -0.15, 0.05}, {0.1, -0.2, 0.15});
  for (int i = 0; i < 40; ++i)
    for (int k = 0; k < 40; ++k) {
      const double a = 0.05 * i, b = 0.05 * k;
      for (const Vector3d& p : {Vector3d(a, b, 0.0), Vector3d(a, 0.0, b), Vector3d(0.0, a, b)}) {
        target.push_back(p);
        source.push_back(X_TS.inverse() * p);
      }
    }
  const tracking::CloudRegistration clouds(source, target);
  const Transform found = clouds.align(Transform::Identity());
  // A voxel has 60 mm; planes are aligned to a part of it.
  EXPECT_LT((found.translation() - X_TS.translation()).norm(), 0.01);
  EXPECT_LT(angleBetween(found, X_TS), unit::deg(0.3));
  const tracking::CloudRegistration none({}, target);
  EXPECT_EQ(none.align(X_TS).matrix(), X_TS.matrix());
}

}  // namespace room_pose_test
}  // namespace abstand::testing
