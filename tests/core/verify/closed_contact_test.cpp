// Closed forms of forces against plain summation; figures of numbers.
#include "core/verify/closed_contact.hpp"

#include <gtest/gtest.h>

#include "core/geometry/shape.hpp"
#include "core/verify/check_tools.hpp"
#include "core/verify/meshes.hpp"
#include "core/verify/statistics.hpp"

namespace abstand::verify {
namespace closed_contact_test {

TEST(ClosedContact, BallInBallMatchesIntegral) {
  constexpr double kSmall = 0.05, kLarge = 0.08;
  for (const double depth : {0.002, 0.02, 0.05}) {
    const double c = kSmall + kLarge - depth;
    constexpr int kBands = 200'000;
    double sum = 0.0;
    for (int i = 0; i < kBands; ++i) {
      const double u = -1.0 + 2.0 * (i + 0.5) / kBands;
      const double deep = kLarge - std::sqrt(c * c + kSmall * kSmall - 2.0 * c * kSmall * u);
      if (deep > 0.0) sum += 2.0 * kPi * kSmall * kSmall * deep * u * 2.0 / kBands;
    }
    EXPECT_NEAR(ballInBallForce(kSmall, kLarge, c), sum, 1e-6 * sum);
  }
}

TEST(ClosedContact, LargeBallMatchesWall) {
  // The cap's volume, in the limit of a flat wall: the rim of the cap lies rim^2 / 2R lower.
  constexpr double kLarge = 20.0, kSmall = 0.05, kDepth = 0.01;
  const double force = ballInBallForce(kSmall, kLarge, kLarge + kSmall - kDepth);
  EXPECT_NEAR(force, capVolume(kSmall, kDepth), 0.01 * force);
}

TEST(ClosedContact, SubmergedVolumeAndCentroidMatchClosedForm) {
  const geometry::TriangleMesh box = boxMesh({2, 1, 1});
  const Submerged half = submerged(box, Transform::Identity());
  EXPECT_NEAR(half.volume, 1.0, 1e-12);
  EXPECT_NEAR((half.centroid - Vector3d(0, 0, -0.25)).norm(), 0.0, 1e-12);
  EXPECT_EQ(submerged(box, fromXyzRpy({0, 0, 3}, {0, 0, 0})).volume, 0.0);
  // All of a turned box: volume and centre, whatever the turn.
  const Submerged all = submerged(box, fromXyzRpy({0.3, 0.1, -5}, {0.4, 1.0, 2.0}));
  EXPECT_NEAR(all.volume, 2.0, 1e-12);
  EXPECT_NEAR((all.centroid - Vector3d(0.3, 0.1, -5)).norm(), 0.0, 1e-12);
  // A ball's cap; the mesh lies within its sagitta of the ball.
  const geometry::TriangleMesh ball = geometry::tessellate(geometry::Sphere{0.05}, 1e-6);
  EXPECT_NEAR(submerged(ball, fromXyzRpy({0, 0, 0.04}, {0, 0, 0})).volume, capVolume(0.05, 0.01),
              1e-3 * capVolume(0.05, 0.01));
}

TEST(ClosedContact, PinInHoleMatchesSum) {
  constexpr double kPin = 0.02, kHole = 0.021, kOffset = 0.003, kLength = 0.03;
  constexpr int kParts = 1'000'000;
  double sum = 0.0;
  for (int i = 0; i < kParts; ++i) {
    const double phi = 2.0 * kPi * (i + 0.5) / kParts;
    const double rho = std::hypot(kOffset + kPin * std::cos(phi), kPin * std::sin(phi));
    if (rho > kHole) sum += (rho - kHole) * std::cos(phi) * kPin * kLength * 2.0 * kPi / kParts;
  }
  EXPECT_NEAR(pinInHoleForce(kPin, kHole, kOffset, kLength), sum, 1e-8 * sum);
}

TEST(Statistics, MeansAndSlopesMatchClosedForm) {
  EXPECT_NEAR(rms({3, 4}), std::sqrt(12.5), 1e-15);
  EXPECT_NEAR(logSlope({1, 2, 4}, {3, 12, 48}), 2.0, 1e-12);
}

TEST(Statistics, CheckFailsBeyondLimitForNaNAndWithoutValues) {
  CheckResult r;
  judge(r, {0.5, 1.0}, 1.0);
  EXPECT_TRUE(r.passed);
  judge(r, {0.5, 1.0001}, 1.0);
  EXPECT_FALSE(r.passed);
  EXPECT_EQ(r.breaches, 1u);
  judge(r, {0.5, kNaN}, 1.0);
  EXPECT_FALSE(r.passed);
  judge(r, {}, 1.0);
  EXPECT_FALSE(r.passed);
}

}  // namespace closed_contact_test
}  // namespace abstand::verify
