#include "core/scene/motion_bound.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/random_pose.hpp"

namespace abstand::scene {
namespace motion_bound_test {

// Sines and norms near 1.
constexpr double kRounding = 1e-12;

const geometry::EnclosingSphere kSphere{{0.3, -0.2, 0.5}, 0.7};

/// A point of the sphere, on its surface for even k.
Vector3d pointOf(const geometry::EnclosingSphere& sphere, std::uint64_t k) {
  const Vector3d direction = testing::randomPose(k, 0.0).linear().col(0);
  const double share = k % 2 == 0 ? 1.0 : testing::randomUnit(k, 7);
  return sphere.centre + share * sphere.radius * direction;
}

Transform turned(double angle, const Vector3d& axis, const Vector3d& shift = Vector3d::Zero()) {
  Transform X = Transform::Identity();
  X.linear() = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
  X.translation() = shift;
  return X;
}

TEST(MotionBound, BoundsDisplacementOfEveryPoint) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    MotionBound reach(kSphere);
    Transform before = testing::randomPose(seed, 2.0);
    reach.moveTo(before);
    const double begin = reach.travelled();
    const Transform first = before;
    for (std::uint64_t k = 0; k < 8; ++k) {
      // From tiny turns to half a turn, and matrices that are off a rotation as far as a scene takes them.
      const double size = std::pow(10.0, -6.0 + 6.5 * testing::randomUnit(seed, 20 + k));
      const Vector3d axis = testing::randomPose(100 * seed + k, 1.0).translation();
      Transform now = turned(size, axis, size * axis) * before;
      if (seed % 2 == 0) now.linear()(static_cast<int>(k) % 3, static_cast<int>(seed) % 3) += 4e-7;
      ASSERT_TRUE(isPose(now));
      const double step = reach.moveTo(now);
      for (std::uint64_t i = 0; i < 40; ++i) {
        const Vector3d p = pointOf(kSphere, 1000 * seed + 40 * k + i);
        ASSERT_LE((now * p - before * p).norm(), step) << seed << " " << k;
        ASSERT_LE((now * p - first * p).norm(), reach.travelled() - begin + kRounding) << seed << " " << k;
        ASSERT_LE((now * p - reach.centre()).norm(), reach.radius() + kRounding);
      }
      before = now.matrix().allFinite() ? now : before;
      before.linear() = Quaterniond(before.linear()).normalized().toRotationMatrix();
      reach.moveTo(before);
    }
  }
}

TEST(MotionBound, IsSharp) {
  // A shift: the shift. A turn about the centre: the chord of the equator, so the diameter for half a turn.
  MotionBound reach({Vector3d::Zero(), 2.0});
  EXPECT_NEAR(reach.moveTo(turned(0.0, Vector3d::UnitX(), {3, 4, 0})), 5.0, kRounding);
  reach.moveTo(Transform::Identity());
  for (const double angle : {1e-6, 0.1, 1.0, 2.0, kPi}) {
    EXPECT_NEAR(reach.moveTo(turned(angle, {1, 2, 3})), 4.0 * std::sin(angle / 2), kRounding) << angle;
    reach.moveTo(Transform::Identity());
  }
  EXPECT_LT(reach.moveTo(Transform::Identity()), kRounding) << "standing still";
}

TEST(MotionBound, LongSumsNeverUnderestimate) {
  // 1e-9 m a step is far below the resolution of plain sums when the way is long.
  MotionBound reach({Vector3d::Zero(), 0.1});
  reach.moveTo(turned(0.0, Vector3d::UnitX(), {1e6, 0, 0}));
  reach.moveTo(Transform::Identity());
  const double begin = reach.travelled();
  Transform X = Transform::Identity();
  constexpr int kSteps = 100000;
  for (int i = 1; i <= kSteps; ++i) {
    X.translation().x() = 1e-9 * i;
    reach.moveTo(X);
  }
  EXPECT_GE(reach.travelled() - begin, 1e-9 * kSteps);
}

TEST(MotionBound, GapIsNeverAbovePointDistance) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    MotionBound a(kSphere), b({{0, 0.1, 0}, 0.2});
    const Transform X_WA = testing::randomPose(seed, 1.5), X_WB = testing::randomPose(seed + 1000, 1.5);
    a.moveTo(X_WA);
    b.moveTo(X_WB);
    for (std::uint64_t i = 0; i < 40; ++i) {
      const Vector3d p = X_WA * pointOf(kSphere, seed + 2 * i),
                     q = X_WB * pointOf({{0, 0.1, 0}, 0.2}, seed + 4 * i);
      ASSERT_LE(gapOf(a, b), (p - q).norm());
    }
  }
  MotionBound a({{0, 0, 0}, 0.5}), b({{2, 0, 0}, 0.25});
  EXPECT_NEAR(gapOf(a, b), 1.25, kRounding);
}

}  // namespace motion_bound_test
}  // namespace abstand::scene
