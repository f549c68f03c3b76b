// Cameras placed by the room that another camera sees, too.
#include "tracking/depth/calibration/room_pose.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "tests/tracking/depth/calibration/pose_errors.hpp"
#include "tests/tracking/depth/calibration/room_cases.hpp"
#include "tracking/depth/calibration/cloud_registration.hpp"
#include "tracking/depth/calibration/room_warnings.hpp"
#include "tracking/depth/calibration/still_image.hpp"

namespace abstand::testing {
namespace room_pose_test {

constexpr double kMove = 0.1, kTurn = unit::deg(10.0);

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
    const RoomCase c = roomCase({}, seed, 160, 3);
    const tracking::RoomFit fit = tracking::fitPoseToRoom(c.known, c.camera);
    // A Kinect's step at 3 m is 26 mm; 10,000 points and more leave a part of it.
    EXPECT_LT((fit.X_WC.translation() - c.truth.translation()).norm(), 0.01) << seed;
    EXPECT_LT(angleBetween(fit.X_WC, c.truth), unit::deg(0.3)) << seed;
    EXPECT_GT(fit.agreement.agreeing, 0.95) << seed;
    EXPECT_GT(fit.agreement.shared, 0.3) << seed;
    EXPECT_NEAR(fit.moved, kMove, 0.01) << seed;
    EXPECT_NEAR(fit.turned, kTurn, unit::deg(0.3)) << seed;
    // What is said of a point 1 m from the middle of the points holds.
    const Vector3d p_C(0.2, 0.1, 2.0);
    EXPECT_LT((fit.X_WC * p_C - c.truth * p_C).norm(), 3.0 * std::sqrt(3.0) * fit.spread) << seed;
  }
}

TEST(RoomPose, IsDeterministicAndAddsSpreadOfKnownCamera) {
  const RoomCase c = roomCase({}, 1, 160, 3);
  const tracking::RoomFit fit = tracking::fitPoseToRoom(c.known, c.camera);
  auto [known, camera] = camerasOf(1, 160);
  known.spread = 0.02;
  const tracking::RoomView uncertain(known, roomSeen(known, roomOf({}, 1), 2, 3));
  const tracking::RoomFit again = tracking::fitPoseToRoom(uncertain, c.camera);
  EXPECT_EQ(again.X_WC.matrix(), fit.X_WC.matrix());
  EXPECT_NEAR(again.spread, std::hypot(fit.spread, 0.02), 1e-12);
}

TEST(RoomPose, RejectsUndeterminedDegreesOfFreedom) {
  const RoomCase floor = roomCase({.walls = 0, .objects = false}, 1, 160, 5);
  EXPECT_THAT(refusal(floor.known, floor.camera),
              ::testing::HasSubstr("do not determine every degree of freedom"));
  // The noise of single images does not count as a determination.
  for (const int images : {1, 5}) {
    const RoomCase wall = roomCase({.walls = 1, .objects = false}, 2, 160, images);
    EXPECT_THAT(refusal(wall.known, wall.camera),
                ::testing::HasSubstr("do not determine every degree of freedom"))
        << images;
  }
}

/// A case of a room at the wall, with a start that is `move` (m) off along the wall.
RoomCase atWall(const std::vector<Box>& boxes, double move) {
  const std::array<tracking::DepthCamera, 2> cameras = wallCameras(160);
  Transform start = cameras[1].X_WC;
  start.translation().y() += move;
  return roomCase(boxes, cameras, 1, 10, start);
}

double errorOf(const tracking::RoomFit& fit, const RoomCase& c) {
  return (fit.X_WC.translation() - c.truth.translation()).norm();
}

// Two boxes determine the translation along the wall. These were refused.
TEST(RoomPose, TakesFloorWallAndFurnitureWithTheirSpread) {
  std::vector<Box> boxes = wallRoom();
  boxes.push_back({{0.6, 0.4, 0.5}, fromXyzRpy({-1.4, -1.0, 0.25}, {0.0, 0.0, 0.3})});
  boxes.push_back({{0.5, 0.9, 0.8}, fromXyzRpy({-1.2, 1.0, 0.4}, {0.0, 0.0, -0.2})});
  const RoomCase c = atWall(boxes, 0.1);
  const tracking::RoomFit fit = tracking::fitPoseToRoom(c.known, c.camera);
  EXPECT_LT(errorOf(fit, c), 0.01);  // as in RecoversPoseFromWrongStarts
  EXPECT_LT(errorOf(fit, c), 3.0 * fit.spread);
  // Few surfaces determine it: the spread is that of systematic errors, ten times and more the RMS distance.
  EXPECT_GT(fit.spread, 8.0 * fit.rms);
  EXPECT_LT(fit.spread, 0.1);
  EXPECT_EQ(fit.rival, kInfinity);
  EXPECT_TRUE(fit.is_start_near);
}

// The poses one and two periods aside had a lower cost, since the cameras would be nearer to each other.
TEST(RoomPose, DecidesBetweenRepeatedPartsByTheStart) {
  // At 0.2 m a pose one period aside is as near, but more of the shelves is seen through: 0.039 unexplained.
  for (const double move : {0.0, -0.1, 0.2}) {
    const RoomCase c = atWall(shelfRoom(), move);
    const tracking::RoomFit fit = tracking::fitPoseToRoom(c.known, c.camera);
    EXPECT_LT(errorOf(fit, c), 0.01) << move;
    EXPECT_NEAR(fit.rival, 0.4, 0.03) << move << ": the period";
    EXPECT_LT(fit.agreement.seen_through, 2e-4) << move;
  }
  // Half a period off to the other side (0.024), and at wrong poses.
  for (const double move : {-0.2, 0.4, -0.4}) {
    const RoomCase c = atWall(shelfRoom(), move);
    EXPECT_THAT(
        refusal(c.known, c.camera),
        ::testing::MatchesRegex("--room: found poses 0\\.(4.|39|38) m apart that explain the room nearly "
                                "equally, .* within 0\\.1. m and 20 degrees of the true pose"))
        << move;
  }
}

TEST(RoomPose, ThingsThatAreNotRepeatedDecide) {
  std::vector<Box> boxes = shelfRoom();
  boxes.push_back({{0.8, 0.6, 0.9}, fromXyzRpy({-1.0, 0.0, 0.45}, {0.0, 0.0, 0.4})});
  const RoomCase c = atWall(boxes, 0.2);
  const tracking::RoomFit fit = tracking::fitPoseToRoom(c.known, c.camera);
  EXPECT_LT(errorOf(fit, c), 0.01);
  EXPECT_EQ(fit.rival, kInfinity);
}

// The pose in which the moved box fits to itself is no rival.
TEST(RoomPose, TakesRoomWithOneMovedBox) {
  std::vector<Box> boxes = wallRoom();
  boxes.push_back({{8.0, 0.1, 3.0}, fromXyzRpy({0.0, -2.2, 1.5}, Vector3d::Zero())});
  boxes.push_back({{0.6, 0.4, 0.5}, fromXyzRpy({-1.4, -1.0, 0.25}, {0.0, 0.0, 0.3})});
  boxes.push_back({{0.4, 0.4, 1.1}, fromXyzRpy({0.9, -1.7, 0.55}, {0.0, 0.0, 0.5})});
  std::vector<Box> later = boxes;
  boxes.push_back({{0.5, 0.9, 0.8}, fromXyzRpy({-1.2, 1.0, 0.4}, {0.0, 0.0, -0.2})});
  later.push_back({{0.5, 0.9, 0.8}, fromXyzRpy({-1.2, 1.15, 0.4}, {0.0, 0.0, -0.2})});
  const auto [known, camera] = wallCameras(160);
  const tracking::RoomView before(known, roomSeen(known, boxes, 2, 10)),
      after(camera, roomSeen(camera, later, 3, 10));
  const tracking::RoomFit fit = tracking::fitPoseToRoom(before, after);
  EXPECT_LT((fit.X_WC.translation() - camera.X_WC.translation()).norm(), 0.01);
  EXPECT_EQ(fit.rival, kInfinity);
}

// The sides of posts are narrow and their normals rounded: an error of 5 mm had a spread of 0.6 mm.
TEST(RoomPose, SpreadIncludesSystematicErrorsOfNarrowSurfaces) {
  const RoomCase c = atWall(postRoom(), 0.0);
  const tracking::RoomFit fit = tracking::fitPoseToRoom(c.known, c.camera);
  EXPECT_LT(errorOf(fit, c), 3.0 * fit.spread);
  EXPECT_NEAR(fit.rival, 0.3, 0.03);
}

TEST(RoomPose, SaysThatStartIsFar) {
  const RoomCase c = roomCase({}, 1, 160, 3, 0.3, unit::deg(10.0));
  const tracking::RoomFit fit = tracking::fitPoseToRoom(c.known, c.camera);
  EXPECT_LT(errorOf(fit, c), 0.01);
  EXPECT_FALSE(fit.is_start_near);
  const RoomCase near = roomCase({}, 1, 160, 3, 0.2, unit::deg(20.0));
  EXPECT_TRUE(tracking::fitPoseToRoom(near.known, near.camera).is_start_near);
}

TEST(RoomPose, RejectsViewsWithoutOverlapAndChangedRooms) {
  const RoomCase c = roomCase({}, 1, 160, 3);
  auto [known, camera] = camerasOf(1, 160);
  // A camera that looks at the other side of the room.
  tracking::DepthCamera away = camera;
  away.X_WC = camera.X_WC * Eigen::AngleAxisd(kPi, Vector3d::UnitY());
  EXPECT_THAT(refusal(c.known, tracking::RoomView(away, roomSeen(away, roomOf({}, 1), 5, 3))),
              ::testing::StartsWith("--room: found "));
  // Large boxes that only one camera saw.
  std::vector<Box> changed = roomOf({}, 1);
  for (const double x : {-1.0, 0.0})
    changed.push_back({{0.6, 0.6, 1.8}, fromXyzRpy({x, -x - 1.0, 0.9}, Vector3d::Zero())});
  EXPECT_THAT(refusal(c.known, tracking::RoomView(camera, roomSeen(camera, changed, 6, 3))),
              ::testing::StartsWith("--room: found that the cameras agree on"));
  const tracking::DepthImage nothing(160, 120);
  EXPECT_THAT(refusal(c.known, tracking::RoomView(camera, nothing)),
              ::testing::HasSubstr("found 0 points that both cameras see"));
}

TEST(RoomPose, WarnsOfRivalsFarStartsAndFewSurfaces) {
  tracking::RoomFit fit;
  fit.agreement.weakest = 0.05;
  EXPECT_TRUE(tracking::warningsOf(fit).empty());
  fit.rival = 0.4;
  fit.is_start_near = false;
  fit.moved = 0.3;
  fit.turned = unit::deg(12.0);
  fit.agreement.weakest = 0.005;
  EXPECT_THAT(tracking::warningsOf(fit),
              ::testing::ElementsAre(
                  ::testing::StartsWith("a pose 0.40 m away explains the room nearly as well"),
                  ::testing::StartsWith("found a pose 0.30 m and 12 degrees from the start, "
                                        "expected at most 0.2 m and 20 degrees"),
                  ::testing::StartsWith("few surfaces, as of furniture, determine one direction")));
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
  const tracking::RoomView view(known, roomSeen(known, roomOf({.walls = 1, .objects = false}, 3), 1, 5));
  EXPECT_GT(view.points().size(), 5000u);
  std::size_t off = 0;
  for (const tracking::RoomPoint& point : view.points()) {
    const Vector3d n_W = known.X_WC.linear() * point.n_C, p_W = known.X_WC * point.p_C;
    EXPECT_LT(n_W.dot(p_W - known.X_WC.translation()), 0.0) << "towards the camera";
    off += std::max(n_W.z(), n_W.x()) < std::cos(unit::deg(10.0));
    EXPECT_EQ(view.at(point.p_C) != nullptr, true);
  }
  // Measured: 0.032 of 18,188 points.
  EXPECT_LT(static_cast<double>(off), 0.035 * static_cast<double>(view.points().size()))
      << "but along the edge";
  EXPECT_EQ(view.at({0.0, 0.0, -1.0}), nullptr);
  EXPECT_EQ(view.at({5.0, 0.0, 1.0}), nullptr);
}

// With points up to 0.2 m nearer or farther in the patches, these had 13.5 and 23.8 degrees.
TEST(RoomView, NormalsStopAtEdges) {
  std::vector<double> squares;
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    const tracking::DepthCamera camera = camerasOf(seed, 320)[0];
    const std::vector<Box> boxes = roomOf({}, seed);
    const tracking::RoomView view(camera, roomSeen(camera, boxes, seed, 20));
    const std::vector<Vector3d> truth = trueNormals(camera, rendered(camera, boxes));
    for (const tracking::RoomPoint& point : view.points()) {
      const Eigen::Vector2d pixel = camera.pixelOf(point.p_C);
      const auto u = std::lround(pixel.x()), v = std::lround(pixel.y());
      if (u < 0 || v < 0 || u >= camera.width || v >= camera.height) continue;
      const Vector3d& n = truth[static_cast<std::size_t>(v * camera.width + u)];
      if (!n.isZero(0.0)) squares.push_back(std::pow(std::acos(std::clamp(n.dot(point.n_C), -1.0, 1.0)), 2));
    }
  }
  ASSERT_GT(squares.size(), 50000u);
  double sum = 0.0;
  for (const double s : squares) sum += s;
  std::sort(squares.begin(), squares.end());
  // Measured: 5.4 and 9.4 degrees.
  EXPECT_LT(std::sqrt(sum / static_cast<double>(squares.size())), unit::deg(7.0));
  EXPECT_LT(std::sqrt(squares[squares.size() * 95 / 100]), unit::deg(12.0));
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
