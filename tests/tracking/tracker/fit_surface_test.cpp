// Surfaces of the fit against points that lie on them, differences and each other.
#include "tracking/tracker/fit_surface.hpp"

#include <gtest/gtest.h>

#include "tests/support/random_pose.hpp"
#include "tests/tracking/body/random_rig_pose.hpp"
#include "tests/tracking/tracker/test_surface.hpp"

namespace abstand::tracking {
namespace fit_surface_test {

class FitSurfaceKinds : public ::testing::TestWithParam<bool> {};

TEST_P(FitSurfaceKinds, LevelMatchesGradient) {
  constexpr double kStep = 1e-6, kTolerance = 1e-3;  // 1/m; the gradient is some 10/m
  const FitSurface s = surfaceOf(GetParam());
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Vector3d p = testing::randomPose(seed, 0.15).translation();
    Vector3d gradient, other;
    s.level(p, gradient);
    for (int k = 0; k < 3; ++k) {
      const double up = s.level(p + kStep * Vector3d::Unit(k), other);
      const double down = s.level(p - kStep * Vector3d::Unit(k), other);
      EXPECT_NEAR((up - down) / (2.0 * kStep), gradient[k], kTolerance);
    }
  }
}

TEST_P(FitSurfaceKinds, FacingSurfacePointsHaveZeroDistance) {
  const FitSurface s = surfaceOf(GetParam());
  const Transform X_WS = testing::randomPose(5, 1.0);
  const Vector3d eye = X_WS * Vector3d(3.0, 0.5, 0.2);
  int facing = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Vector3d gradient;
    const Vector3d way = testing::randomPose(seed, 1.0).translation().normalized() * 0.1;
    const Vector3d p = way / s.level(way, gradient);
    s.level(p, gradient);
    const Vector3d p_W = X_WS * (s.centre.cast<double>() + p), n = X_WS.linear() * gradient.normalized();
    const SurfaceDistance hit = seenDistance(s, X_WS, X_WS.inverse(), p_W, (p_W - eye).normalized());
    if (n.dot((p_W - eye).normalized()) > 0.0) {
      // The far side is not what the camera sees: the near side has to come back to the point.
      if (n.dot((p_W - eye).normalized()) > 0.2) {
        EXPECT_LT(hit.d, -0.02);
      }
      continue;
    }
    ++facing;
    EXPECT_NEAR(hit.d, 0.0, 1e-7);
    EXPECT_GT(hit.n.dot(n), 0.9999);
    // Half a millimetre outwards is half a millimetre away, to first order.
    const Vector3d out = p_W + 5e-4 * n;
    EXPECT_NEAR(seenDistance(s, X_WS, X_WS.inverse(), out, (out - eye).normalized()).d, 5e-4, 2e-5);
  }
  EXPECT_GT(facing, 20);
}

INSTANTIATE_TEST_SUITE_P(Kinds, FitSurfaceKinds, ::testing::Bool(),
                         [](const auto& one) { return one.param ? "drum" : "ellipsoid"; });

}  // namespace fit_surface_test
}  // namespace abstand::tracking
