// Shares of a surface that a depth camera sees, against closed forms and rays.
#include "app/coverage/occlusion_view.hpp"

#include <gtest/gtest.h>

#include <random>

namespace abstand::coverage {
namespace occlusion_view_test {

constexpr std::size_t kPoints = 40000;
/// Standard deviation of a share of the quarter of the points that face the camera, three times, and half a
/// pixel at the rims.
constexpr double kSampling = 3.0 * 0.5 / 100.0, kRim = 0.01;

std::vector<tracking::SurfaceSample> samplesOf(const geometry::Surface& surface) {
  const geometry::Surface* one = &surface;
  return tracking::sampleSurfaces({&one, 1}, kPoints, 7);
}

Transform at(double x, double y, double z) { return fromXyzRpy({x, y, z}, Vector3d::Zero()); }

/// The camera is at the origin and looks along z.
struct OcclusionViewTest : ::testing::Test {
  static geometry::TriangleMesh box(double x, double y, double z) {
    return geometry::makeSurface(geometry::Shape(geometry::Cuboid{{x, y, z}}))->mesh(1e-3);
  }
  std::unique_ptr<geometry::Surface> ball(double radius) const {
    return geometry::makeSurface(geometry::Shape(geometry::Sphere{radius}));
  }
  double share(Cause cause, const Transform& X_WB) const {
    return static_cast<double>(shareOf(view.shares(0, samples, X_WB), cause));
  }

  const std::unique_ptr<geometry::Surface> part{ball(0.1)};
  const std::vector<tracking::SurfaceSample> samples{samplesOf(*part)};
  OcclusionView view{sensorNamed("kinect"), 2, 640};
};

TEST_F(OcclusionViewTest, FreeBallIsSeen) {
  EXPECT_EQ(share(Cause::kSeen, at(0, 0, 2)), 1.0);
  // Its own surface is no occluder.
  view.drawPerson(0, part->mesh(1e-4), at(0, 0, 2));
  EXPECT_EQ(share(Cause::kSeen, at(0, 0, 2)), 1.0);
}

TEST_F(OcclusionViewTest, HalfOfBallIsBehindEdge) {
  // The edge is in the plane x = 0 of the camera and of the ball: the halves are mirror images.
  view.drawThing(box(1.0, 1.0, 0.2), at(0.5, 0, 1));
  EXPECT_NEAR(share(Cause::kThing, at(0, 0, 2)), 0.5, kSampling + kRim);
  EXPECT_NEAR(share(Cause::kSeen, at(0, 0, 2)), 0.5, kSampling + kRim);
}

TEST_F(OcclusionViewTest, BallHidesItsSolidAngle) {
  // A ball of radius r at distance d fills the cone with sin(a) = r / d, of solid angle 2 pi (1 - cos(a)).
  const auto cone = [](double r, double d) { return 1.0 - std::sqrt(1.0 - r * r / (d * d)); };
  view.drawRobot(ball(0.03)->mesh(1e-5), at(0, 0, 1));
  const double expected = cone(0.03, 1.0) / cone(0.1, 2.0);
  ASSERT_NEAR(expected, 0.36, 0.01);
  // The pixels are 1.7 mm wide there: half of one at the rim of 30 mm changes the area by 6 %.
  EXPECT_NEAR(share(Cause::kRobot, at(0, 0, 2)), expected, kSampling + 0.06 * expected);
  EXPECT_NEAR(share(Cause::kSeen, at(0, 0, 2)), 1.0 - expected, kSampling + 0.06 * expected);
}

TEST_F(OcclusionViewTest, CameraThatIsTurnedAwaySeesNothing) {
  EXPECT_EQ(share(Cause::kOutOfImage, at(0, 0, -2)), 1.0);
  // The right edge of the image is at half a pixel beyond column 639: x = 320 / 580 z.
  EXPECT_EQ(share(Cause::kOutOfImage, at(2.0 * 320 / 580 + 0.2, 0, 2)), 1.0);
  const double half = share(Cause::kOutOfImage, at(2.0 * 320 / 580, 0, 2));
  EXPECT_NEAR(half, 0.5, kSampling + kRim);
}

TEST_F(OcclusionViewTest, RangeEndsWhereTheSensorSays) {
  EXPECT_EQ(share(Cause::kOutOfRange, at(0, 0, 8.2)), 1.0);
  EXPECT_EQ(share(Cause::kSeen, at(0, 0, 8.0)), 1.0) << "the camera sees the near half";
  EXPECT_EQ(share(Cause::kOutOfRange, at(0, 0, 0.3)), 1.0);
  // The plane z = 0.5 cuts the visible cap of a ball around (0, 0, 0.6 - 0.05).
  const double cut = share(Cause::kOutOfRange, at(0, 0, 0.55));
  EXPECT_GT(cut, 0.3);
  EXPECT_LT(cut, 1.0);
  EXPECT_EQ(share(Cause::kOutOfRange, at(0, 0, 0)), 1.0) << "around the camera";
}

TEST_F(OcclusionViewTest, RangeCutsCapOfClosedForm) {
  // A point of the ball at an angle b from the axis towards the camera has the depth d - r cos(b). Depths
  // below the nearest are those with cos(b) > (d - nearest) / r. Their solid angle is that of the circle
  // around the axis with radius r sin(b) at this depth.
  const double r = 0.1, d = 0.55, nearest = 0.5;
  const double cosine = (d - nearest) / r, radius = r * std::sqrt(1.0 - cosine * cosine);
  const double cap = 1.0 - nearest / std::hypot(nearest, radius);
  const double whole = 1.0 - std::sqrt(1.0 - r * r / (d * d));
  EXPECT_NEAR(share(Cause::kOutOfRange, at(0, 0, d)), cap / whole, kSampling);
}

TEST_F(OcclusionViewTest, NearestBodyIsTheCause) {
  view.drawThing(box(1, 1, 0.02), at(0, 0, 1.0));
  view.drawRobot(box(1, 1, 0.02), at(0, 0, 1.5));
  EXPECT_EQ(share(Cause::kThing, at(0, 0, 2)), 1.0);
  view.drawPerson(1, box(1, 1, 0.02), at(0, 0, 0.8));
  EXPECT_EQ(share(Cause::kOtherPerson, at(0, 0, 2)), 1.0);
  view.drawPerson(0, box(1, 1, 0.02), at(0, 0, 0.7));
  EXPECT_EQ(share(Cause::kSelf, at(0, 0, 2)), 1.0);
  view.clear();
  EXPECT_EQ(share(Cause::kSeen, at(0, 0, 2)), 1.0);
}

TEST_F(OcclusionViewTest, OwnBodyHidesFromItsGapOn) {
  // A plate whose front is `gap` before the nearest point of the ball.
  const auto with_plate = [&](double gap) {
    view.clear();
    view.drawPerson(0, box(1, 1, 0.02), at(0, 0, 1.9 - gap + 0.01));
    return share(Cause::kSelf, at(0, 0, 2));
  };
  EXPECT_EQ(with_plate(OcclusionView::kOwnGap + 0.002), 1.0);
  EXPECT_LT(with_plate(-0.02), 0.01) << "of the rest of the cap, which is at most 0.1 m deep";
}

/// Whether the segment from the origin to `p` meets the triangle (Moeller, Trumbore 1997).
bool crosses(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d e = b - a, f = c - a, h = p.cross(f);
  const double det = e.dot(h);
  if (std::abs(det) < 1e-15) return false;
  const double u = -a.dot(h) / det;
  const Vector3d q = (-a).cross(e);
  const double v = p.dot(q) / det, t = f.dot(q) / det;
  return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 && t < 1.0;
}

TEST_F(OcclusionViewTest, SharesAreThoseOfRays) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int round = 0; round < 10; ++round) {
    SCOPED_TRACE(round);
    view.clear();
    const Transform X_WB = at(0.1 * unit(random), 0.1 * unit(random), 2.0 + 0.3 * unit(random));
    std::vector<std::array<Vector3d, 3>> triangles;
    for (int k = 0; k < 3; ++k) {
      const geometry::TriangleMesh mesh = box(0.06, 0.05, 0.04);
      const Transform X_WO = fromXyzRpy({0.08 * unit(random), 0.08 * unit(random), 1.2 + 0.2 * unit(random)},
                                        {unit(random), unit(random), unit(random)});
      view.drawRobot(mesh, X_WO);
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        triangles.push_back({X_WO * mesh.corner(t, 0), X_WO * mesh.corner(t, 1), X_WO * mesh.corner(t, 2)});
    }
    double hidden = 0.0, all = 0.0;
    for (std::size_t i = 0; i < samples.size(); i += 10) {
      const Vector3d p = X_WB * samples[i].p;
      const double weight = -p.dot(samples[i].normal) / std::pow(p.norm(), 3);
      if (weight <= 0.0) continue;
      all += weight;
      bool meets = false;
      for (const auto& [a, b, c] : triangles) meets |= crosses(p, a, b, c);
      if (meets) hidden += weight;
    }
    EXPECT_NEAR(share(Cause::kRobot, X_WB), hidden / all, 2.0 * kSampling + kRim);
  }
}

TEST(Sensor, ReducedImageHasTheSameView) {
  const tracking::DepthCamera camera = sensorNamed("kinect_v2").camera;
  const tracking::DepthCamera small = reduced(camera, 128);
  EXPECT_EQ(small.width, 128);
  EXPECT_EQ(small.height, 106);
  // The edges of the images are the same rays.
  for (const double edge : {0.0, 1.0}) {
    EXPECT_NEAR((edge * small.width - 0.5 - small.cx) / small.fx,
                (edge * camera.width - 0.5 - camera.cx) / camera.fx, 1e-12);
    EXPECT_NEAR((edge * small.height - 0.5 - small.cy) / small.fy,
                (edge * camera.height - 0.5 - camera.cy) / camera.fy, 1e-12);
  }
  EXPECT_EQ(reduced(camera, 1000).width, 512);
}

}  // namespace occlusion_view_test
}  // namespace abstand::coverage
