// Cameras placed by an arm of plain shapes in a rendered room.
#include "tracking/depth/calibration/surface_pose.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.hpp"
#include "tests/tracking/depth/calibration/pose_errors.hpp"
#include "tracking/depth/simulator/depth_render.hpp"
#include "tracking/depth/simulator/kinect_noise.hpp"

namespace abstand::testing {
namespace surface_pose_test {

Transform movedTo(const Vector3d& p) { return Transform(Eigen::Translation3d(p)); }

/// A column, an upper arm and a forearm, whose elbow is bent by `bend` (rad).
struct Arm {
  Arm() {
    surfaces.push_back(geometry::makeSurface(geometry::Cylinder{0.09, 0.6}));
    surfaces.push_back(geometry::makeSurface(geometry::Capsule{0.06, 0.4}));
    surfaces.push_back(geometry::makeSurface(geometry::Cuboid{{0.09, 0.09, 0.4}}));
    for (const auto& s : surfaces) bodies.push_back(s.get());
  }
  static std::vector<Transform> at(double bend) {
    const Transform upper = fromXyzRpy({0.0, 0.2, 0.95}, {-0.9, 0.0, 0.0});
    const Transform elbow = upper * fromXyzRpy({0.0, 0.0, 0.24}, {bend, 0.5, 0.0});
    return {movedTo({0.0, 0.0, 0.5}), upper, elbow * movedTo({0.0, 0.0, 0.22})};
  }
  std::vector<std::unique_ptr<geometry::Surface>> surfaces;
  std::vector<const geometry::Surface*> bodies;
};

tracking::DepthCamera kinect(const Vector3d& eye, const Vector3d& target) {
  tracking::DepthCamera camera;
  camera.width = 320;
  camera.height = 240;
  camera.fx = camera.fy = 290.0;
  camera.cx = 159.5;
  camera.cy = 119.5;
  camera.X_WC = tracking::lookingAt(eye, target);
  return camera;
}

/// What a Kinect sees of the bodies, a floor, a wall, a table beside them and a ball in front.
tracking::SurfaceView seen(const tracking::DepthCamera& camera,
                           const std::vector<const geometry::Surface*>& bodies,
                           const std::vector<Transform>& X_WB, std::uint64_t seed) {
  tracking::DepthRender render(camera);
  const Transform X_CW = camera.X_WC.inverse();
  for (std::size_t b = 0; b < bodies.size(); ++b) render.draw(bodies[b]->mesh(5e-4), X_CW * X_WB[b]);
  const auto draw = [&](const geometry::Shape& shape, const Vector3d& p) {
    render.draw(geometry::tessellate(shape, 1e-3), X_CW * movedTo(p));
  };
  draw(geometry::Cuboid{{8.0, 8.0, 0.02}}, {0.0, 0.0, -0.01});
  draw(geometry::Cuboid{{0.02, 8.0, 4.0}}, {-1.2, 0.0, 2.0});
  draw(geometry::Cuboid{{0.8, 0.6, 0.04}}, {0.1, -0.6, 0.7});
  draw(geometry::Sphere{0.1}, {0.5, 0.35, 0.55});
  return {tracking::seenByKinect(render.image(), camera, tracking::kinectNoiseIn(camera), seed, 0), X_WB};
}

TEST(SurfacePose, RecoversPoseFromWrongStarts) {
  const Arm arm;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    tracking::DepthCamera camera = kinect({1.7, 0.5, 1.4}, {0.0, 0.1, 0.8});
    const Transform truth = camera.X_WC;
    const std::vector<tracking::SurfaceView> views{seen(camera, arm.bodies, Arm::at(1.2), seed)};
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
    const Vector3d hand = Arm::at(1.2)[2].translation(), p_C = truth.inverse() * hand;
    EXPECT_LT((fit.X_WC * p_C - hand).norm(), 3.0 * std::sqrt(3.0) * fit.spread) << seed;
  }
}

TEST(SurfacePose, SeveralPosturesAreOneFit) {
  const Arm arm;
  tracking::DepthCamera camera = kinect({1.7, 0.5, 1.4}, {0.0, 0.1, 0.8});
  const Transform truth = camera.X_WC;
  std::vector<tracking::SurfaceView> views;
  for (int i = 0; i < 3; ++i)
    views.push_back(seen(camera, arm.bodies, Arm::at(0.5 + 0.5 * i), static_cast<std::uint64_t>(i) + 1));
  camera.X_WC = wrong(truth, 0.1, unit::deg(10.0), 9);
  const tracking::SurfaceFit fit = tracking::fitPoseToSurfaces(camera, arm.bodies, views, 1);
  EXPECT_LT((fit.X_WC.translation() - truth.translation()).norm(), 0.006);
  EXPECT_LT(angleBetween(fit.X_WC, truth), unit::deg(0.2));
  const tracking::SurfaceFit again = tracking::fitPoseToSurfaces(camera, arm.bodies, views, 1);
  EXPECT_EQ(again.X_WC.matrix(), fit.X_WC.matrix());
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
  const tracking::DepthCamera camera = kinect({1.7, 0.5, 1.4}, {0.0, 0.1, 0.8});
  const auto ball = geometry::makeSurface(geometry::Sphere{0.25});
  EXPECT_THAT(refusal(camera, {ball.get()}, seen(camera, {ball.get()}, {movedTo({0.0, 0.1, 0.9})}, 1)),
              ::testing::HasSubstr("do not determine every degree of freedom"));
  const auto cylinder = geometry::makeSurface(geometry::Cylinder{0.2, 3.0});
  EXPECT_THAT(
      refusal(camera, {cylinder.get()}, seen(camera, {cylinder.get()}, {movedTo({0.0, 0.1, 0.9})}, 1)),
      ::testing::HasSubstr("do not determine every degree of freedom"));
}

TEST(SurfacePose, RejectsRobotThatIsNotVisible) {
  const Arm arm;
  const tracking::DepthCamera camera = kinect({1.7, 0.5, 1.4}, {0.0, 0.1, 0.8});
  const tracking::SurfaceView view = seen(camera, arm.bodies, Arm::at(1.2), 1);
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
