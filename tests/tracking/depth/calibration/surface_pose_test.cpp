// Cameras placed by an arm of plain shapes in a rendered room.
#include "tracking/depth/calibration/surface_pose.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.hpp"
#include "tests/tracking/depth/calibration/arm_view.hpp"
#include "tests/tracking/depth/calibration/links_trial.hpp"
#include "tests/tracking/depth/calibration/pose_errors.hpp"

namespace abstand::testing {
namespace surface_pose_test {

TEST(SurfacePose, RecoversPoseFromWrongStarts) {
  const PlainArm arm;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    tracking::DepthCamera camera = smallKinect({1.7, 0.5, 1.4}, {0.0, 0.1, 0.8});
    const Transform truth = camera.X_WC;
    const std::vector<tracking::SurfaceView> views{armSeen(camera, arm.bodies, PlainArm::at(1.2), seed)};
    camera.X_WC = wrong(truth, 0.1, unit::deg(10.0), seed);
    const tracking::SurfaceFit fit = tracking::fitPoseToSurfaces(camera, arm.bodies, views, seed);
    // A Kinect's step at 1.9 m is 10 mm; 2,000 points and more leave a part of it.
    EXPECT_LT((fit.X_WC.translation() - truth.translation()).norm(), 0.012) << seed;
    EXPECT_LT(angleBetween(fit.X_WC, truth), unit::deg(0.5)) << seed;
    EXPECT_GT(fit.explained, 0.8) << seed;
    EXPECT_LT(fit.rms, 0.01) << seed;
    EXPECT_NEAR(fit.moved, 0.1, 0.015) << seed;
    EXPECT_NEAR(fit.turned, unit::deg(10.0), unit::deg(0.6)) << seed;
    // What is said of a point of the arm's hand holds.
    const Vector3d hand = PlainArm::at(1.2)[2].translation(), p_C = truth.inverse() * hand;
    EXPECT_LT((fit.X_WC * p_C - hand).norm(), 3.0 * std::sqrt(3.0) * fit.spread) << seed;
  }
}

TEST(SurfacePose, SeveralPosturesAreOneFit) {
  const PlainArm arm;
  tracking::DepthCamera camera = smallKinect({1.7, 0.5, 1.4}, {0.0, 0.1, 0.8});
  const Transform truth = camera.X_WC;
  std::vector<tracking::SurfaceView> views;
  for (int i = 0; i < 3; ++i)
    views.push_back(
        armSeen(camera, arm.bodies, PlainArm::at(0.5 + 0.5 * i), static_cast<std::uint64_t>(i) + 1));
  camera.X_WC = wrong(truth, 0.1, unit::deg(10.0), 9);
  const tracking::SurfaceFit fit = tracking::fitPoseToSurfaces(camera, arm.bodies, views, 1);
  EXPECT_LT((fit.X_WC.translation() - truth.translation()).norm(), 0.006);
  EXPECT_LT(angleBetween(fit.X_WC, truth), unit::deg(0.2));
  const tracking::SurfaceFit again = tracking::fitPoseToSurfaces(camera, arm.bodies, views, 1);
  EXPECT_EQ(again.X_WC.matrix(), fit.X_WC.matrix());
}

// An audit found 44 mm where 11 mm were stated: with points within 25 mm of the surfaces alone, whose noise
// is 27 mm at 3.5 m, as if that were all of their noise, and with the lever arm of people, not of the camera.
TEST(SurfacePose, StatedSpreadHoldsFarAway) {
  for (const LinksCase& c : {LinksCase{.distance = 1.9}, LinksCase{.distance = 3.5},
                             LinksCase{.distance = 4.0, .images = 2, .aside = 2.1}}) {
    double squares = 0.0;
    constexpr int kSeeds = 5;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      const LinksTrial trial = linksTrial(c, seed);
      ASSERT_TRUE(trial.is_taken) << trial.refusal;
      const double ratio = trial.camera_error / trial.fit.spread;
      EXPECT_LT(ratio, 3.0) << c.distance << " m, seed " << seed;
      squares += ratio * ratio / kSeeds;
    }
    // 0.5 to 1.1 in 30 seeds of each case.
    EXPECT_GT(std::sqrt(squares), 0.25) << c.distance << " m: far too careful";
    EXPECT_LT(std::sqrt(squares), 1.8) << c.distance << " m";
  }
}

TEST(SurfacePose, RejectsRobotThatIsTooSmall) {
  const LinksTrial trial = linksTrial({.distance = 5.5}, 1);
  EXPECT_THAT(trial.refusal,
              ::testing::HasSubstr("expected 100 or less: the robot is too small in the images"));
}

/// What a fit says that refuses.
std::string refusal(const tracking::DepthCamera& camera, const std::vector<const geometry::Surface*>& bodies,
                    const tracking::SurfaceView& view) {
  try {
    tracking::fitPoseToSurfaces(camera, bodies, std::span(&view, 1), 1);
  } catch (const UsageError& e) {
    return e.what();
  }
  return "taken";
}

TEST(SurfacePose, RejectsBallAndSingleCylinder) {
  const tracking::DepthCamera camera = smallKinect({1.7, 0.5, 1.4}, {0.0, 0.1, 0.8});
  const auto ball = geometry::makeSurface(geometry::Sphere{0.25});
  EXPECT_THAT(refusal(camera, {ball.get()}, armSeen(camera, {ball.get()}, {movedTo({0.0, 0.1, 0.9})}, 1)),
              ::testing::HasSubstr("do not determine every degree of freedom"));
  const auto cylinder = geometry::makeSurface(geometry::Cylinder{0.2, 3.0});
  EXPECT_THAT(
      refusal(camera, {cylinder.get()}, armSeen(camera, {cylinder.get()}, {movedTo({0.0, 0.1, 0.9})}, 1)),
      ::testing::HasSubstr("do not determine every degree of freedom"));
}

TEST(SurfacePose, RejectsRobotThatIsNotVisible) {
  const PlainArm arm;
  const tracking::DepthCamera camera = smallKinect({1.7, 0.5, 1.4}, {0.0, 0.1, 0.8});
  const tracking::SurfaceView view = armSeen(camera, arm.bodies, PlainArm::at(1.2), 1);
  // The robot is said to stand elsewhere, and behind the camera.
  for (const Vector3d& p : {Vector3d(-0.3, 0.9, 0.3), Vector3d(4.0, 0.0, 0.0)}) {
    tracking::SurfaceView moved = view;
    for (Transform& X_WB : moved.X_WB) X_WB = movedTo(p) * X_WB;
    EXPECT_THAT(refusal(camera, arm.bodies, moved), ::testing::StartsWith("--links: found "))
        << p.transpose();
  }
  tracking::SurfaceView nothing = view;
  std::fill(nothing.image.z.begin(), nothing.image.z.end(), 0.0f);
  EXPECT_THAT(refusal(camera, arm.bodies, nothing), ::testing::HasSubstr("found 0 points on the robot"));
  // A wall where the camera should see the arm.
  tracking::SurfaceView wall = view;
  std::fill(wall.image.z.begin(), wall.image.z.end(), 3.0f);
  EXPECT_NE(refusal(camera, arm.bodies, wall), "taken");
}

TEST(SurfaceSamples, AreDistributedByArea) {
  const auto large = geometry::makeSurface(geometry::Cuboid{{0.4, 0.4, 0.4}}),
             small = geometry::makeSurface(geometry::Sphere{0.1});
  const std::vector<const geometry::Surface*> bodies{large.get(), small.get()};
  const auto samples = tracking::sampleSurfaces(bodies, 2000, 3);
  ASSERT_EQ(samples.size(), 2000u);
  double on_small = 0.0;
  for (const tracking::SurfaceSample& s : samples) {
    EXPECT_LT(bodies[s.body]->closest(s.p).distance, 1.1e-3);  // of the tessellation
    EXPECT_GT(bodies[s.body]->signedDistance(s.p + 0.01 * s.normal), 0.0);
    on_small += s.body == 1 ? 1.0 : 0.0;
  }
  EXPECT_NEAR(on_small / 2000.0, small->area() / (small->area() + large->area()), 0.01);
}

}  // namespace surface_pose_test
}  // namespace abstand::testing
