// A round link that is elsewhere than the images show it, before a wall.
#include "tracking/tracker/displaced_things.hpp"

#include <gtest/gtest.h>

#include "tests/tracking/tracker/small_camera.hpp"
#include "tracking/depth/simulator/kinect_noise.hpp"

namespace abstand::tracking {
namespace displaced_things_test {

constexpr double kDepth = 2.0, kRadius = 0.07, kWall = 3.0;  // m

DepthCamera levelCamera() {
  DepthCamera camera = smallCamera();
  camera.X_WC = Transform::Identity();
  return camera;
}

/// An upright cylinder at `aside` and `nearer` (m), before a wall, or nothing, at `wall` (m).
DepthImage linkAt(double aside, double nearer, double wall) {
  const DepthCamera camera = levelCamera();
  DepthImage image(camera.width, camera.height);
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      // |z (x, 1) - c|^2 = r^2 for the ray through (x, y, 1).
      const Eigen::Vector2d ray = Eigen::Vector2d(camera.at(u, v, 1.0).x(), 1.0), c(aside, kDepth - nearer);
      const double b = ray.dot(c) / ray.squaredNorm();
      const double root = b * b - (c.squaredNorm() - kRadius * kRadius) / ray.squaredNorm();
      image.at(u, v) = static_cast<float>(root >= 0.0 ? b - std::sqrt(root) : wall);
    }
  }
  return image;
}

DepthImage measured(const DepthImage& truth) {
  const DepthCamera camera = levelCamera();
  return seenByKinect(truth, camera, kinectNoiseIn(camera), 1, 0);
}

DisplacedThings compared(const DepthImage& image) {
  DisplacedThings displaced;
  displaced.add(image, linkAt(0.0, 0.0, 0.0), levelCamera());
  return displaced;
}

TEST(DisplacedThings, AreMeasuredToTheSideAndAlongTheRay) {
  constexpr double kTolerance = 0.02;  // m: a pixel is 14 mm, a step of the depth 12 mm
  for (const double d : {0.06, 0.08, 0.1}) {
    for (const auto& [aside, nearer] : {std::pair{d, 0.0}, {-d, 0.0}, {0.0, d}, {0.0, -d}}) {
      const DisplacedThings displaced = compared(measured(linkAt(aside, nearer, kWall)));
      EXPECT_TRUE(displaced.areNear()) << aside << " " << nearer;
      EXPECT_NEAR(displaced.displacement(), d, kTolerance) << aside << " " << nearer;
      EXPECT_GE(displaced.band(), d) << "what hides must hold the link";
    }
  }
}

TEST(DisplacedThings, NeedNoBandInTheirPlace) {
  const DisplacedThings displaced = compared(measured(linkAt(0.0, 0.0, kWall)));
  EXPECT_TRUE(displaced.areNear());
  EXPECT_EQ(displaced.band(), 0.0);
  EXPECT_EQ(compared(measured(linkAt(0.01, 0.0, kWall))).band(), 0.0) << "less than a pixel";
}

TEST(DisplacedThings, AreNotNearIfAbsentOrElsewhere) {
  EXPECT_FALSE(compared(measured(linkAt(5.0, 0.0, kWall))).areNear());
  EXPECT_FALSE(compared(measured(linkAt(0.4, 0.0, kWall))).areNear());
}

TEST(DisplacedThings, AreNotComparedWhereHidden) {
  DepthImage image = linkAt(0.0, 0.0, kWall);
  for (float& z : image.z) z = 1.0f;
  EXPECT_TRUE(std::isnan(compared(image).share()));
  EXPECT_FALSE(compared(image).areNear());
  EXPECT_EQ(compared(image).band(), 0.0);
}

/// Every point within the band of a surface point is hidden, and none beyond it.
TEST(BandedThings, HoldAllWithinTheBand) {
  constexpr double kBand = 0.08, kPixel = kDepth / 145.0;  // m
  const DepthCamera camera = levelCamera();
  const DepthImage known = linkAt(0.0, 0.0, 0.0);
  BandedThings banded;
  EXPECT_EQ(&banded.around(known, camera, 0.0), &known);
  const DepthImage& band = banded.around(known, camera, kBand);
  for (const double angle : {0.0, 0.5, 1.0, 1.5}) {
    const auto depthAt = [&](double distance) {
      const double x = (kRadius + distance) * std::sin(angle),
                   z = kDepth - (kRadius + distance) * std::cos(angle);
      const int u = static_cast<int>(std::lround(camera.cx + camera.fx * x / z));
      return std::pair{static_cast<double>(band.at(u, camera.height / 2)), z};
    };
    const auto [inside, z_inside] = depthAt(kBand - 1.5 * kPixel);
    EXPECT_TRUE(inside > 0.0 && inside <= z_inside + kPixel) << angle;
    const auto [outside, z_outside] = depthAt(kBand + 1.5 * kPixel);
    EXPECT_TRUE(outside <= 0.0 || outside > z_outside - kPixel) << angle;
  }
}

}  // namespace displaced_things_test
}  // namespace abstand::tracking
