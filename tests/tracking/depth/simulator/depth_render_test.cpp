// Rendered depths against rays, and the noise against its law.
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.hpp"
#include "core/geometry/shape.hpp"
#include "core/math/random.hpp"
#include "tracking/depth/simulator/depth_render.hpp"
#include "tracking/depth/simulator/kinect_noise.hpp"

namespace abstand::testing {
namespace depth_render_test {

constexpr double kFloat = 1e-6;    // of a depth: images are kept in float
constexpr double kRadius = 0.3;    // m
constexpr double kSagitta = 1e-4;  // m, of the tessellated ball

Transform at(double x, double y, double z) {
  Transform X = Transform::Identity();
  X.translation() = Vector3d(x, y, z);
  return X;
}

geometry::TriangleMesh wall(double left, double right) {
  geometry::TriangleMesh mesh;
  mesh.vertices = {{left, -5, 0}, {right, -5, 0}, {right, 5, 0}, {left, 5, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

TEST(DepthRender, BallMatchesRayIntersection) {
  const tracking::DepthCamera camera;
  tracking::DepthRender render(camera);
  const Vector3d centre(0.2, -0.1, 1.7);
  render.draw(geometry::tessellate(geometry::Ellipsoid{{kRadius, kRadius, kRadius}}, kSagitta),
              at(0.2, -0.1, 1.7));
  int inside = 0;
  for (int v = 0; v < camera.height; v += 3) {
    for (int u = 0; u < camera.width; u += 3) {
      const Vector3d ray = camera.at(u, v, 1.0);
      const double along = ray.dot(centre) / ray.squaredNorm();
      const double miss = (along * ray - centre).norm();
      const float z = render.image().at(u, v);
      if (miss > kRadius) {
        EXPECT_EQ(z, 0.0f) << u << " " << v;
      } else if (miss < 0.99 * kRadius) {  // nearer the rim a ray is steep to the facets
        const double depth = along - std::sqrt(kRadius * kRadius - miss * miss) / ray.norm();
        EXPECT_NEAR(z, depth, 10.0 * kSagitta) << u << " " << v;
        ++inside;
      }
    }
  }
  EXPECT_GT(inside, 1000);
}

TEST(DepthRender, KeepsNearestAndClipsBehindCamera) {
  tracking::DepthRender render({});
  render.draw(wall(-5, 5), at(0, 0, 3));
  render.draw(wall(-5, 0), at(0, 0, 2));
  render.draw(wall(-5, 5), at(0, 0, 4));
  render.draw(wall(-5, 5), at(0, 0, -1));
  EXPECT_NEAR(render.image().at(10, 100), 2.0, 2.0 * kFloat);
  EXPECT_NEAR(render.image().at(630, 100), 3.0, 3.0 * kFloat);
  // A wall through the camera's plane: z = 1 + x beside it.
  render.clear();
  Transform X = at(0, 0, 1);
  X.linear() = Eigen::AngleAxisd(-kPi / 4, Vector3d::UnitY()).toRotationMatrix();
  render.draw(wall(-5, 5), X);
  const tracking::DepthCamera camera;
  for (const int u : {0, 100, 500}) {
    const double slope = camera.at(u, 0, 1.0).x();
    EXPECT_NEAR(render.image().at(u, 240), 1.0 / (1.0 - slope), 10.0 * kFloat) << u;
  }
  tracking::DepthCamera bent;
  bent.distortion[0] = 0.1;
  EXPECT_THROW(tracking::DepthRender{bent}, UsageError);
}

TEST(KinectNoise, WallHasModelledSpreadAndSteps) {
  const tracking::DepthCamera camera;
  const tracking::KinectNoise noise;
  for (const double z : {1.0, 2.0, 4.0}) {
    tracking::DepthRender render(camera);
    render.draw(wall(-20, 20), at(0, 0, z));
    const tracking::DepthImage seen = tracking::seenByKinect(render.image(), camera, noise, 1, 0);
    double sum = 0.0, squares = 0.0;
    int n = 0;
    for (int v = 100; v < 380; ++v) {
      for (int u = 100; u < 540; ++u) {
        const double d = static_cast<double>(seen.at(u, v));
        ASSERT_GT(d, 0.0);
        const double steps = camera.fx * noise.baseline / d / noise.disparity_step;
        ASSERT_NEAR(steps, std::round(steps), 1e-3);
        sum += d - z, squares += (d - z) * (d - z), ++n;
      }
    }
    const double step = z * z * noise.disparity_step / (camera.fx * noise.baseline);
    const double along = noise.along + noise.along_growth * (z - 0.4) * (z - 0.4);
    // Rounding to steps adds their variance, or shifts all by up to half of one.
    EXPECT_LT(std::abs(sum / n), 0.5 * step + 0.05 * along) << z;
    EXPECT_LT(std::sqrt(squares / n), std::hypot(along, 0.5 * step) * 1.05) << z;
    EXPECT_GT(std::sqrt(squares / n), 0.7 * along) << z;
  }
}

TEST(KinectNoise, ShadowWidthFollowsProjectorBaseline) {
  const tracking::DepthCamera camera;
  tracking::KinectNoise noise;
  noise.across = 0.0;
  tracking::DepthRender render(camera);
  render.draw(wall(-0.2, 0.2), at(0, 0, 1.5));
  render.draw(wall(-20, 20), at(0, 0, 3.0));
  const tracking::DepthImage seen = tracking::seenByKinect(render.image(), camera, noise, 1, 0);
  int dark = 0, left = 0;
  const double edge = camera.fx * -0.2 / 1.5 + camera.cx;
  for (int u = 0; u < camera.width; ++u) {
    if (seen.at(u, 240) > 0.0f) continue;
    ++dark;
    left += u < edge;
  }
  const double width = camera.fx * noise.baseline * (1 / 1.5 - 1 / 3.0);
  EXPECT_NEAR(dark, width, 2.0);
  EXPECT_EQ(left, dark);
}

// The plain formula of Box and Muller, for each pixel.
TEST(KinectNoise, PixelsAreDisplacedByNormalDeviates) {
  constexpr std::uint64_t kSeed = 3, kFrame = 2;
  const auto depthOf = [](int u) { return 2.0f + 0.001f * static_cast<float>(u); };  // m, tells the column
  tracking::DepthCamera camera;
  tracking::DepthImage ideal(camera.width, camera.height);
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) ideal.at(u, v) = depthOf(u);
  tracking::KinectNoise noise;
  noise.along = noise.along_growth = 0.0;
  noise.disparity_step = 1e-6;
  for (const double across : {0.4, 0.8, 3.0}) {
    noise.across = across;
    const tracking::DepthImage seen = tracking::seenByKinect(ideal, camera, noise, kSeed, kFrame);
    for (int v = 0; v < camera.height; ++v) {
      Random random(kSeed, kFrame * tracking::DepthCamera::kMaxPixels + static_cast<std::uint64_t>(v));
      const auto displaced = [&](int from) {
        const double u = 1.0 - random.unit(), w = random.unit();
        return from + static_cast<int>(
                          std::lround(across * (std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * kPi * w))));
      };
      for (int u = 0; u < camera.width; ++u) {
        const int from_u = displaced(u), from_v = displaced(v);
        random.unit(), random.unit();  // of the depth
        const bool is_inside = from_u >= 0 && from_v >= 0 && from_u < camera.width && from_v < camera.height;
        ASSERT_NEAR(seen.at(u, v), is_inside ? depthOf(from_u) : 0.0f, 1e-4)
            << across << ": " << u << " " << v;
      }
    }
  }
}

TEST(KinectNoise, HalvedImageHasSameDepthNoise) {
  tracking::DepthCamera half;
  half.width = 320, half.height = 240;
  half.fx = half.fy = 290.0;
  const tracking::KinectNoise whole, scaled = tracking::kinectNoiseIn(half);
  EXPECT_DOUBLE_EQ(scaled.across, 0.5 * whole.across);
  // z^2 / (f b) times the step of the disparity.
  EXPECT_DOUBLE_EQ(scaled.disparity_step / half.fx, whole.disparity_step / 580.0);
  EXPECT_DOUBLE_EQ(scaled.along, whole.along);
}

TEST(KinectNoise, IsReproducibleForSameSeed) {
  const tracking::DepthCamera camera;
  tracking::DepthRender render(camera);
  render.draw(wall(-1, 1), at(0, 0, 2));
  const auto seen = [&](std::uint64_t seed, std::uint64_t frame) {
    return tracking::seenByKinect(render.image(), camera, {}, seed, frame).z;
  };
  EXPECT_EQ(seen(1, 0), seen(1, 0));
  EXPECT_NE(seen(1, 0), seen(2, 0));
  EXPECT_NE(seen(1, 0), seen(1, 1));
}

}  // namespace depth_render_test
}  // namespace abstand::testing
