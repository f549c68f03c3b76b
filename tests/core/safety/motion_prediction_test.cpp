// Predictions by weighted average velocity.
#include "core/safety/motion_prediction.hpp"

#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "core/math/random.hpp"
#include "tests/support/no_alloc.hpp"

namespace abstand::safety {
namespace motion_prediction_test {

constexpr double kExact = 1e-12;

Transform moved(double t, const Vector3d& v, const Vector3d& w) {
  Transform X = fromXyzRpy({0.3, -0.2, 1.0}, {0.1, 0.2, 0.3});
  X.linear() = Eigen::AngleAxisd(w.norm() * t, w.normalized()).toRotationMatrix() * Matrix3d(X.linear());
  X.translation() += t * v;
  return X;
}

TEST(MotionPrediction, FollowsConstantMotionExactly) {
  const Vector3d v(0.5, -1.0, 0.2), w(0.3, 2.0, -1.0);
  for (const double fade : {0.0, 0.5, 1.0}) {
    MotionPrediction p({.fade = fade});
    for (int i = 0; i <= 12; ++i) {
      // Poses come unevenly.
      const double t = 0.01 * i + 0.004 * (i % 3);
      EXPECT_TRUE(p.add(t, moved(t, v, w)));
    }
    EXPECT_NEAR((p.velocity().linear - v).norm(), 0.0, kExact) << fade;
    EXPECT_NEAR((p.velocity().angular - w).norm(), 0.0, 1e-10) << "of small angles";
    EXPECT_NEAR((p.at(0.25).matrix() - moved(p.t() + 0.25, v, w).matrix()).norm(), 0.0, 1e-10);
    EXPECT_EQ(p.at(0.0).matrix(), moved(p.t(), v, w).matrix());
  }
}

TEST(MotionPrediction, WeightsStepsByAge) {
  // Steps of 1, 2 and 3 m/s over equal times, fade 1/2: (3 + 2/2 + 1/4) / (1 + 1/2 + 1/4).
  MotionPrediction p({.fade = 0.5});
  double x = 0.0;
  p.add(0.0, Transform::Identity());
  for (int i = 1; i <= 3; ++i) {
    x += 0.1 * i;
    p.add(0.1 * i, Transform(Eigen::Translation3d(x, 0, 0)));
  }
  EXPECT_NEAR(p.velocity().linear.x(), 4.25 / 1.75, kExact);
}

TEST(MotionPrediction, AveragingReducesNoise) {
  double spread_last = 0.0, spread_mean = 0.0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Random random(3, seed);
    MotionPrediction last({.fade = 0.0}), mean({.fade = 0.8});
    for (int i = 0; i < 10; ++i) {
      const double t = i / 30.0;
      const Transform X(Eigen::Translation3d(Vector3d(1.0, 0, 0) * t + random.inCube(0.01)));
      last.add(t, X);
      mean.add(t, X);
    }
    spread_last += (last.velocity().linear - Vector3d::UnitX()).squaredNorm();
    spread_mean += (mean.velocity().linear - Vector3d::UnitX()).squaredNorm();
  }
  // Of 8 steps of weights 0.8^k only the ends' noise and the changes of weight remain.
  EXPECT_LT(spread_mean, 0.1 * spread_last);
}

TEST(MotionPrediction, IgnoresInvalidSteps) {
  MotionPrediction p({.longest_gap = 0.2});
  EXPECT_FALSE(p.add(kNaN, Transform::Identity()));
  EXPECT_TRUE(p.add(0.0, Transform::Identity()));
  EXPECT_FALSE(p.add(0.0, Transform(Eigen::Translation3d(1, 0, 0)))) << "no time has passed";
  EXPECT_TRUE(p.add(0.1, Transform(Eigen::Translation3d(0.1, 0, 0))));
  Transform broken = Transform::Identity();
  broken.translation().x() = kNaN;
  EXPECT_FALSE(p.add(0.2, broken));
  EXPECT_NEAR(p.velocity().linear.x(), 1.0, kExact);
  EXPECT_TRUE(p.add(0.5, Transform(Eigen::Translation3d(9, 0, 0)))) << "after a gap it starts anew";
  EXPECT_EQ(p.velocity().linear, Vector3d::Zero());
  p.clear();
  EXPECT_TRUE(p.add(0.0, Transform::Identity()));
}

TEST(MotionPrediction, AllocatesNothing) {
  MotionPrediction p;
  double sum = 0.0;
  const testing::NoAlloc guard;
  for (int i = 0; i < 100; ++i) {
    p.add(0.01 * i, moved(0.01 * i, Vector3d::UnitX(), Vector3d::UnitY()));
    sum += p.at(0.1).translation().x();
  }
  EXPECT_EQ(guard.count(), 0);
  EXPECT_GT(sum, 0.0);
}

TEST(MotionPrediction, RejectsBadOptions) {
  EXPECT_THROW(MotionPrediction({.fade = 1.5}), UsageError);
  EXPECT_THROW(MotionPrediction({.longest_gap = 0.0}), UsageError);
}

}  // namespace motion_prediction_test
}  // namespace abstand::safety
